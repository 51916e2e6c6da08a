#pragma once

#include "renderer/context/context.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

/// An OpenGL context without a window, and the scene renderer in it.
class OffscreenRenderer {
 public:
  /// `backend` as in renderer::create_context. Throws renderer::ContextError.
  explicit OffscreenRenderer(const std::string& backend)
      : context_(renderer::create_context(backend)), renderer_(*context_) {}

  renderer::SceneRenderer& renderer() { return renderer_; }
  /// The name OpenGL gives its renderer (GL_RENDERER).
  const std::string& gl_renderer() const { return context_->renderer(); }

 private:
  std::unique_ptr<renderer::Context> context_;
  renderer::SceneRenderer renderer_;
};

}  // namespace taut::app
