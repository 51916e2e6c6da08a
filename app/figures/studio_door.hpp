#pragma once

#include <memory>
#include <string>
#include <utility>

#include "app/drawing/studio.hpp"

namespace taut::app {

/// Opens a studio when the first picture is to be drawn in it: diagrams and plots need none.
class StudioDoor {
 public:
  /// Pictures get `scale` times as many pixels each way as figures ask for.
  StudioDoor(std::string backend, float scale) : backend_(std::move(backend)), scale_(scale) {}

  Studio& open() {
    if (!studio_) {
      studio_ = std::make_unique<Studio>(backend_);
    }
    return *studio_;
  }
  float scale() const { return scale_; }
  /// Empty while none is open.
  std::string gl_renderer() const { return studio_ ? studio_->gl_renderer() : ""; }

 private:
  std::string backend_;
  float scale_;
  std::unique_ptr<Studio> studio_;
};

}  // namespace taut::app
