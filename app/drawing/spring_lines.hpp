#pragma once

#include "app/drawing/drawn_scene.hpp"

namespace taut::app {

/// Returns the colour of a kind of spring. People with any kind of colour vision can distinguish them (Okabe and Ito
/// 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  constexpr std::array colours = {renderer::rgb(0x0072B2), renderer::rgb(0xE69F00), renderer::rgb(0xCC3377)};
  return colours[static_cast<std::size_t>(kind)];
}

/// Colours of a surface under lines.
inline const renderer::Colour pale_outside = renderer::rgb(0xE8EDF2);
inline const renderer::Colour pale_inside = renderer::rgb(0xF3DFC0);

/// Draws the springs of a garment as lines over its surface.
class SpringLines {
 public:
  /// `width_px`: width of structural and shear springs, in pixels of the picture.
  SpringLines(const sim::Garment& garment, WhichSprings shown, float width_px);

  /// Adds the lines for these positions in metres, one per vertex. They refer to this object and are valid until its
  /// next call.
  void add(std::span<const glm::vec3> positions, renderer::FrameView& frame);

 private:
  struct SewingLines {
    std::vector<sim::Edge> springs;
    renderer::Colour colour;
    float width_px;
    std::vector<glm::vec3> points;
  };

  std::vector<SewingLines> lines_;  ///< ordered as they are drawn
};

/// Returns true if springs of this kind are shown.
bool shows(WhichSprings shown, sim::SpringKind kind);

}  // namespace taut::app
