#pragma once

#include <memory>

#include "renderer/context/context.hpp"

namespace taut::renderer {

// Each function returns a new context, current in the calling thread, or throws ContextError with the reason.

/// Returns a context of libOSMesa, Mesa's off-screen library. Mesa 25.1 removed it, so it may be absent.
std::unique_ptr<Context> create_osmesa_context();
/// Returns a context of EGL without a surface. Needs neither a display nor a window system.
std::unique_ptr<Context> create_egl_context();

}  // namespace taut::renderer
