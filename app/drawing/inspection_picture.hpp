#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

/// Lines or dots of one meaning in the picture of an inspection.
struct InspectionMarks {
  std::string meaning;  ///< legend text with the count
  renderer::Colour colour{0.0F};
  float width_px = 1.0F;               ///< width of lines or diameter of dots
  float opacity = 1.0F;                ///< lines only
  bool dots = false;                   ///< true: one point per dot; false: two points per line
  bool seen_through = false;           ///< drawn over surfaces that would hide it
  std::vector<glm::vec3> points = {};  ///< positions in metres
};

/// Sizes of marks.
struct MarkWidths {
  float spring_px = 1.0F;  ///< width of structural springs
  float dot_px = 6.0F;
};

/// Returns all marks of the garment in drawing order: later ones cover earlier ones. Crossing triangles are outlined as
/// drawn, at rest.
std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded, std::span<const sim::CrossingPair> crossings,
                                              const MarkWidths& widths);

/// Returns a page that shows the interpretation of the garment, from the front and from behind: springs by kind, pins,
/// borders, welded vertices, edges with more than two triangles, and edges whose triangles disagree about the outside.
/// It has a legend, counts and a scale bar. `backend`: see renderer::create_context. Throws renderer::ContextError.
renderer::Image draw_inspection(const Inspection& inspection, const LoadedGarment& loaded, const DrawnScene& scene,
                                std::span<const sim::Body> bodies, const std::string& backend);

/// Returns a page that shows the current state, with the blocked triangles outlined and the position marked: in the
/// scene's view and as a close-up. `text` is the heading.
renderer::Image draw_blocked(renderer::SceneRenderer& renderer, const DrawnScene& scene,
                             const sim::Simulation& simulation, const sim::BlockedContact& blocked,
                             const std::string& text);

/// A worn garment to draw.
struct WornGarment {
  const DrawnScene& scene;
  const LoadedBodies& bodies;
  const sim::Garment& garment;
  const std::vector<sim::Vec3>& positions_m;
  double time_s = 0.0;  ///< time of the bodies
  std::vector<FitRow> fit;
  std::string title;
  std::string measured;   ///< line in grey below the title
  std::string tightness;  ///< line below the table
};

/// Draws the garment from the front and from behind, coloured by stretch, with the legend beside it and a table of
/// girths and ease below. `backend`: see renderer::create_context. Throws renderer::ContextError.
renderer::Image draw_fit(const WornGarment& worn, const std::string& backend);

/// A state of a garment, one of a row of pictures.
struct GarmentMoment {
  std::string name;
  const sim::Garment& garment;
  const std::vector<sim::Vec3>& positions_m;
  std::optional<double> time_s;  ///< time of the bodies; empty: no bodies
};

/// Draws the moments side by side from the front, in the scene's style. Throws as draw_fit() does.
renderer::Image draw_moments(const DrawnScene& scene, const LoadedBodies& bodies,
                             std::span<const GarmentMoment> moments, const std::string& backend);

}  // namespace taut::app
