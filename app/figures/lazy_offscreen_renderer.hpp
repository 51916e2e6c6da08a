#pragma once

#include <memory>
#include <string>
#include <utility>

#include "app/drawing/offscreen_renderer.hpp"

namespace taut::app {

/// An OffscreenRenderer that is made at the first open(). Diagrams and plots never open it and need no
/// OpenGL.
class LazyOffscreenRenderer {
 public:
  /// Pictures get `scale` times as many pixels each way as figures ask for.
  LazyOffscreenRenderer(std::string backend, float scale) : backend_(std::move(backend)), scale_(scale) {}

  OffscreenRenderer& open() {
    if (!offscreen_) {
      offscreen_ = std::make_unique<OffscreenRenderer>(backend_);
    }
    return *offscreen_;
  }
  float scale() const { return scale_; }
  /// Empty while none is open.
  std::string gl_renderer() const { return offscreen_ ? offscreen_->gl_renderer() : ""; }

 private:
  std::string backend_;
  float scale_;
  std::unique_ptr<OffscreenRenderer> offscreen_;
};

}  // namespace taut::app
