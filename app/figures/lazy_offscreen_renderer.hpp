#pragma once

#include <memory>
#include <string>
#include <utility>

#include "app/drawing/garment_painter.hpp"

namespace taut::app {

/// Makes the offscreen renderer when it is first needed. Diagrams and plots do not need it.
class LazyOffscreenRenderer {
 public:
  /// `backend` is as in renderer::create_context. Pictures get `scale` times as many pixels each way as the
  /// figures ask for.
  LazyOffscreenRenderer(std::string backend, float scale) : backend_(std::move(backend)), scale_(scale) {}

  /// The renderer. The first call makes it and may throw renderer::ContextError.
  OffscreenRenderer& open() {
    if (!offscreen_) {
      offscreen_ = std::make_unique<OffscreenRenderer>(backend_);
    }
    return *offscreen_;
  }
  float scale() const { return scale_; }
  /// The name OpenGL gives its renderer. Empty before the first `open`.
  std::string gl_renderer() const { return offscreen_ ? offscreen_->gl_renderer() : ""; }

 private:
  std::string backend_;
  float scale_;
  std::unique_ptr<OffscreenRenderer> offscreen_;
};

}  // namespace taut::app
