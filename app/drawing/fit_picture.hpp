#pragma once

#include "app/bodies/fit.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

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

}  // namespace taut::app
