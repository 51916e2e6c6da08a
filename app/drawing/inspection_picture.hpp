#pragma once

#include "app/bodies/fit.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspection.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

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
