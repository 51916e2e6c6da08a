#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "renderer/scene_renderer.hpp"

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

/// Draws a garment at these positions with marks; `is_page`: on a white page.
renderer::Image draw_marked(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                            std::span<const sim::Index> pins, const std::vector<sim::Vec3>& positions_m, double time_s,
                            const std::vector<InspectionMarks>& marks, bool is_page);

/// Sizes of marks.
struct MarkWidths {
  float spring_px = 1.0F;  ///< of structural springs
  float dot_px = 6.0F;
};

/// All marks of the garment, in the order they are drawn: later ones cover earlier ones. Triangles that cross
/// are outlined where they are drawn, which is at rest.
std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, std::span<const CrossingPair> crossings,
                                              const MarkWidths& widths);

constexpr int inspection_panel_px = 1000;  ///< width of one view

/// Two views of the garment as it was modelled, of one size and one scale.
struct InspectionViews {
  struct Side {
    const char* name;
    DrawnScene scene;
  };
  std::array<Side, 2> sides;
  float px_per_m = 0.0F;  ///< at the distance of the garment's middle
  int height_px = 0;      ///< of each view; as small as the garment allows
};

/// Makes the views from the scene that was asked for.
InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Index> pins);

}  // namespace taut::app
