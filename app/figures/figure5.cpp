#include <fmt/core.h>

#include "app/figures/figures.hpp"
#include "app/figures/sheet.hpp"
#include "app/figures/shots.hpp"

namespace taut::app {

// The T-shirt without wind and in two winds.
renderer::Image draw_figure5(Studio& studio) {
  std::vector<Panel> panels;
  for (const char* name : {"tshirt-gravity", "tshirt-wind-1", "tshirt-wind-10"}) {
    const Scene scene = scene_for_print(name, 980, 860);
    Shot shot = take_last_shot(studio, scene);
    const double speed_m_per_s = scene.surroundings.forces.wind.speed_m_per_s;
    panels.push_back({std::move(shot.picture),
                      speed_m_per_s == 0.0 ? "gravity alone" : fmt::format("wind {:.1f} m/s", speed_m_per_s),
                      fmt::format("largest stretch {:.1f} %", 100.0 * shot.record.stretch.max)});
  }
  return compose_sheet(panels, {.columns = 3});
}

}  // namespace taut::app
