#include <fmt/core.h>

#include "app/figures/figures.hpp"
#include "app/figures/sheet.hpp"
#include "app/figures/shots.hpp"

namespace taut::app {

// Over-stretching: the same cloth, held by its upper corners, with two limits of stretch.
renderer::Image draw_figure4(Studio& studio) {
  std::vector<Panel> panels;
  for (const char* name : {"pinned-9x9-5", "pinned-9x9-20"}) {
    const Scene scene = scene_for_print(name, 1200, 1200);
    Shot shot = take_last_shot(studio, scene);
    panels.push_back({std::move(shot.picture),
                      fmt::format("stretched by up to {:.1f} %", 100.0 * shot.record.stretch.max),
                      fmt::format("{} sweeps of the constraint in a step; red: at rest length",
                                  scene.simulation.solver.iterations)});
  }
  return compose_sheet(panels, {.columns = 2});
}

}  // namespace taut::app
