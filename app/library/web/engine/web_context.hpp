#pragma once

#include "renderer/context/context.hpp"

namespace taut::library {

/// WebGL 2 context that the page has made current. It stands in for OpenGL 3.3: what the renderer asks for beyond
/// OpenGL ES 3.0 is translated or has no effect.
class WebContext final : public renderer::Context {
 public:
  /// Throws renderer::ContextError.
  WebContext();
  /// The engine has no other context.
  void make_current() override {}
};

}  // namespace taut::library
