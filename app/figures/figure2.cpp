#include <fmt/core.h>

#include <array>

#include "app/figures/figures.hpp"
#include "app/figures/sheet.hpp"
#include "app/figures/shots.hpp"

namespace taut::app {

// Simulation of cloth falling under the effect of gravity.
renderer::Image draw_figure2(Studio& studio) {
  const Scene scene = scene_for_print("cloth-fall", 720, 620);
  // The fall, the swing to the far side and back, and the cloth at rest.
  const std::array moments = {0, 12, 21, 30, 40, 54, 80, scene.frames};
  std::vector<Panel> panels;
  for (Shot& shot : take_shots(studio, scene, moments)) {
    panels.push_back({std::move(shot.picture), fmt::format("{:.2f} s", shot.record.time_s),
                      fmt::format("largest stretch {:.1f} %", 100.0 * shot.record.stretch.max)});
  }
  return compose_sheet(panels, {.columns = 4});
}

}  // namespace taut::app
