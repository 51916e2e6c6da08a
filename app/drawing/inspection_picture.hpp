#pragma once

#include "app/bodies/fit.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspection.hpp"
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

/// Sizes of marks.
struct MarkWidths {
  float spring_px = 1.0F;  ///< of structural springs
  float dot_px = 6.0F;
};

/// All marks of the garment, in the order they are drawn: later ones cover earlier ones. Triangles that cross
/// are outlined where they are drawn, which is at rest.
std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, std::span<const CrossingPair> crossings,
                                              const MarkWidths& widths);

/// Returns a page that shows how the garment was understood, from the front and from behind. It shows springs
/// by kind, pins, borders, vertices that were welded, edges with more than two triangles, and edges whose
/// triangles disagree about the outside. It has a legend, counts and a scale bar. `backend` is as in
/// renderer::create_context. Throws renderer::ContextError.
renderer::Image draw_inspection(const Inspection& inspection, const LoadedGarment& loaded, const DrawnScene& scene,
                                const std::string& backend);

/// Returns a page that shows the simulation as it is, with what was blocked outlined and its place marked: as
/// the scene is looked at, and from near by. `text` is written above.
renderer::Image draw_blocked(renderer::SceneRenderer& renderer, const DrawnScene& scene,
                             const sim::Simulation& simulation, const sim::BlockedContact& blocked,
                             const std::string& text);

/// A garment that is worn, to be drawn.
struct WornGarment {
  const DrawnScene& scene;
  const sim::Garment& garment;
  const std::vector<sim::Vec3>& positions_m;
  double time_s = 0.0;  ///< at which the bodies are drawn
  std::vector<FitRow> fit;
  std::string title;
  std::string measured;   ///< a line in grey below the title
  std::string tightness;  ///< a line below the table
};

/// Draws it from the front and from behind, coloured by its stretch, with the legend beside it and a table of
/// girths and ease below. `backend` as in renderer::create_context. Throws renderer::ContextError.
renderer::Image draw_fit(const WornGarment& worn, const std::string& backend);

/// A moment of a garment, for a row of them.
struct GarmentMoment {
  std::string name;
  const sim::Garment& garment;
  const std::vector<sim::Vec3>& positions_m;
  std::optional<double> time_s;  ///< at which bodies are drawn; empty: without them
};

/// Draws moments beside each other, from the front, as the scene's cloth looks. Throws as draw_fit() does.
renderer::Image draw_moments(const DrawnScene& scene, std::span<const GarmentMoment> moments,
                             const std::string& backend);

}  // namespace taut::app
