// The same cloth at any number of frames in a second.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

Garment hanging_sheet() {
  GridSettings grid;
  grid.columns = 17;
  grid.rows = 33;
  grid.width_m = 0.5;
  grid.height_m = 1.0;
  return make_garment(make_grid(grid));
}

double stretch_at_rest(const std::shared_ptr<const Garment>& garment, double frame_rate_hz) {
  SimulationSettings settings;
  settings.frame_rate_hz = frame_rate_hz;
  BoundedSettings bounded;
  bounded.max_stretch = 0.05;
  bounded.contact = false;
  settings.solver.method = bounded;
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 2.0;
  surroundings.forces.wind.speed_m_per_s = 1.0;
  Simulation simulation(garment, {0, 16}, settings, surroundings);
  for (int frame = 0; frame < 6.0 * frame_rate_hz; ++frame) {
    simulation.advance_frame();
  }
  return measure_surface_stretch(*garment, simulation.state().current).max;
}

TEST(FrameRate, ClothRestsAtTheSameStretch) {
  const std::shared_ptr<const Garment> garment = share(hanging_sheet());
  const double at_60_hz = stretch_at_rest(garment, 60.0);
  EXPECT_GT(at_60_hz, 0.005);
  EXPECT_LT(at_60_hz, 0.04) << "below the bound, which is the same at any rate";
  EXPECT_NEAR(stretch_at_rest(garment, 24.0), at_60_hz, 0.002);
  EXPECT_NEAR(stretch_at_rest(garment, 240.0), at_60_hz, 0.002);
}

}  // namespace
}  // namespace taut::sim
