#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/page/colour.hpp"
#include "sim/garment.hpp"
#include "sim/springs.hpp"

namespace taut::app {

/// The colour of one kind of spring. People with any kind of colour vision can tell them apart (Okabe and Ito
/// 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  constexpr std::array colours = {renderer::rgb(0x0072B2), renderer::rgb(0xE69F00), renderer::rgb(0xCC3377)};
  return colours[static_cast<std::size_t>(kind)];
}

/// Of a surface that lines are drawn over.
inline const renderer::Colour pale_outside = renderer::rgb(0xE8EDF2);
inline const renderer::Colour pale_inside = renderer::rgb(0xF3DFC0);

/// The springs of a garment as lines over its surface.
class SpringLines {
 public:
  /// `width_px` is that of structural and shear springs, in pixels of the picture.
  SpringLines(const sim::Garment& garment, const ShownSprings& shown, float width_px);

  /// Adds the lines for these positions, in metres, one per vertex. They refer to this object and are valid
  /// until its next call.
  void add(std::span<const glm::vec3> positions, renderer::FrameView& frame);

 private:
  struct Lines {
    std::vector<sim::Edge> springs;
    std::vector<renderer::Colour> colours;  ///< two per spring, or one for all
    float width_px = 1.0F;
    std::vector<glm::vec3> points;
  };

  std::vector<Lines> lines_;  ///< in the order in which they are drawn
};

/// Whether springs of this kind are shown.
bool shows(const ShownSprings& shown, sim::SpringKind kind);

}  // namespace taut::app
