#pragma once

#include <memory>

#include "renderer/context/context.hpp"

namespace taut::renderer {

// One function for each way to get a context; each returns it current or throws ContextError with the reason.

/// Mesa's off-screen library (removed from Mesa in 25.1, so it may be absent at run time).
std::unique_ptr<Context> create_osmesa_context();
/// EGL without a surface: needs neither a display nor a window system.
std::unique_ptr<Context> create_egl_context();

}  // namespace taut::renderer
