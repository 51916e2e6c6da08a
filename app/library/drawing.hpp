#pragma once

#include "app/drawing/garment_painter.hpp"
#include "app/library/session.hpp"

namespace taut::library {

/// An OpenGL context with the program's renderer, and the painter of a cloth.
struct Stage {
  explicit Stage(std::unique_ptr<renderer::Context> current) : context(std::move(current)), renderer(*context) {}

  /// Makes the painter of this session's cloth. `drawn`: the session's scene, in the style of the pictures.
  void dress(const Session& session, const app::DrawnScene& drawn);
  /// Returns the dressed cloth and the bodies at the end of the last frame. Valid until the next call. `shown_m`: see
  /// GarmentPainter::view().
  const renderer::FrameView& view(const Session& session, const std::vector<sim::Vec3>& shown_m = {});

  std::unique_ptr<renderer::Context> context;
  renderer::SceneRenderer renderer;
  std::optional<app::GarmentPainter> painter = {};
};

/// Returns the picture that `taut render` draws of this frame, without a legend. Throws InputError if this machine has
/// no OpenGL that draws without a window, and as SceneRenderer::draw() does.
renderer::Image draw(const Session& session, int width_px, int height_px);

}  // namespace taut::library
