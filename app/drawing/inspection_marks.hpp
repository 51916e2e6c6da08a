#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/models/garment_loading.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/page/colour.hpp"

namespace taut::app {

/// Lines or dots with one meaning, in the picture of an inspection.
struct InspectionMarks {
  std::string meaning;  ///< text of the legend, with the count
  renderer::Colour colour{0.0F};
  float width_px = 1.0F;               ///< of lines; the diameter of dots
  float opacity = 1.0F;                ///< of lines
  bool dots = false;                   ///< `points` holds one point per dot; otherwise two points per line
  bool seen_through = false;           ///< drawn over surfaces that would hide it
  std::vector<glm::vec3> points = {};  ///< in metres
};

/// Of triangles that cross.
inline const renderer::Colour crossing_colour = renderer::rgb(0x00B140);
/// The width of the dark outline that dots have.
inline constexpr float mark_outline_px = 2.0F;

/// Adds what is marked to a picture. It refers to `all`, which has to last until it is drawn.
void add_marks(const std::vector<InspectionMarks>& all, renderer::FrameView& frame);

/// Sizes of marks.
struct MarkWidths {
  float spring_px = 1.0F;  ///< of structural springs
  float dot_px = 6.0F;
};

/// All marks of the garment, in the order they are drawn: later ones cover earlier ones. Triangles that cross
/// are outlined where they are drawn, which is at rest.
std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded,
                                              std::span<const CrossingPair> crossings,
                                              const MarkWidths& widths);

}  // namespace taut::app
