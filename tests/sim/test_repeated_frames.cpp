// A frame whose last correction moved the cloth too far is repeated with more time steps.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "sheets.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/substep_control.hpp"

namespace taut::sim {
namespace {

double max_speed_m_per_s(const State& state) {
  double max_distance_m = 0.0;
  for (std::size_t v = 0; v < state.current.size(); ++v) {
    max_distance_m = std::max(max_distance_m, glm::distance(state.current[v], state.previous[v]));
  }
  return max_distance_m / state.time_step_s;
}

struct Jerk {
  double speed_m_per_s = 0.0;  ///< largest speed of any vertex
  double sweeps = 0.0;         ///< sum over all frames
};

/// Lets a sheet hang by two corners for 40 frames, and pulls it aside with this acceleration for 30.
Jerk jerk(Index count, double max_stretch, double aside_m_per_s2, std::optional<int> substeps = {}) {
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.bound = BoundKind::springs, .max_stretch = max_stretch};
  settings.solver.substeps = substeps;
  Simulation simulation(share(make_garment(sheet(count, 1.0))), {0, count - 1}, settings, {});
  Surroundings aside;
  aside.forces.gravity_m_per_s2.x = aside_m_per_s2;
  Jerk jerk;
  for (int frame = 0; frame < 70; ++frame) {
    if (frame == 40) {
      simulation.set_surroundings(aside);
    }
    simulation.advance_frame();
    EXPECT_TRUE(simulation.frame_report().bound_kept) << frame;
    jerk.speed_m_per_s = std::max(jerk.speed_m_per_s, max_speed_m_per_s(simulation.state()));
    jerk.sweeps += simulation.frame_report().sweeps;
  }
  return jerk;
}

TEST(RepeatedFrames, OfClothThatIsLostTakeMoreStepsUntilTheBudgetIsSpent) {
  bounded::SubstepControl control(8, 1, 40, 1.0 / 60.0);
  int attempts = 0;
  while (control.try_more(std::numeric_limits<double>::quiet_NaN()) && attempts < 100) {
    ++attempts;
  }
  EXPECT_LT(attempts, 10);
  EXPECT_EQ(control.substeps(), 40);
}

/// Returns the steps of a control that began with 100, repeated a frame three times and kept four frames of this cost.
int steps_after_a_hard_frame(double cost_per_step) {
  bounded::SubstepControl control(100, 8, 2000, 1.0 / 60.0);
  for (int more = 0; more < 3; ++more) EXPECT_TRUE(control.try_more(16.0));
  EXPECT_GE(control.substeps(), 400);
  for (int frame = 0; frame < 4; ++frame) control.frame_kept(cost_per_step * control.substeps(), 0.1);
  return control.substeps();
}

TEST(RepeatedFrames, LeaveNoStepsBehindWhereLaterOnesAreCheap) {
  EXPECT_LE(steps_after_a_hard_frame(0.1), 112);
  EXPECT_GE(steps_after_a_hard_frame(2.0), 400);
}

// The sheet's corners would be thrown at 8.4 m/s if no frame were repeated.
TEST(RepeatedFrames, ThrowNothing) {
  EXPECT_LT(jerk(9, 0.01, 40.0).speed_m_per_s, 1.3 * jerk(9, 0.01, 40.0, 200).speed_m_per_s);
}

// Measured: 1761 and 2759 sweeps. The second would take 6435 if a correction of 2 times the allowed shift repeated a
// frame, and not of 3 times.
TEST(RepeatedFrames, AreFew) {
  EXPECT_LT(jerk(13, 0.05, 160.0).sweeps, 1900.0);
  EXPECT_LT(jerk(13, 0.02, 160.0).sweeps, 3500.0);
}

}  // namespace
}  // namespace taut::sim
