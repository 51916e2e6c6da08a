#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/explicit_solvers.hpp"

namespace taut::sim {
namespace {

Garment sheet(Index columns) {
  GridSettings grid;
  grid.columns = grid.rows = columns;
  return make_garment(make_grid(grid));
}

std::vector<Index> top_corners(const Garment& square) {
  const auto columns = static_cast<Index>(std::lround(std::sqrt(square.mesh.positions.size())));
  return {0, columns - 1};
}

// Returns whether springs swing up, by a kinetic energy that hanging cloth never has.
bool swings_up(const Garment& garment, const SimulationSettings& settings, const Surroundings& surroundings) {
  Simulation simulation(share(garment), top_corners(garment), settings, surroundings);
  try {
    for (int frame = 0; frame < 25; ++frame) {
      simulation.advance_frame();
    }
  } catch (const Diverged&) {
    return true;
  }
  double kinetic_j = 0.0;
  for (Index v = 0; v < garment.masses_kg.size(); ++v) {
    const Vec3 speed = velocity(simulation.state(), v);
    kinetic_j += 0.5 * garment.masses_kg[v] * glm::dot(speed, speed);
  }
  return kinetic_j > 10.0;
}

TEST(StableStep, IsVerletsLimitForOneSwingingMass) {
  Garment pair;
  pair.mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  pair.masses_kg = {1.0, 0.01};
  pair.springs.ends = {{0, 1}};
  pair.springs.rest_lengths_m = {1.0};
  pair.springs.structural_count = 1;
  const Pins pins = make_pins(pair, {0});
  // w^2 = 2 k / m by the bound: 2 * 50 / 0.01, so that dt < 2 / 100.
  EXPECT_NEAR(stable_time_step_s(pair, pins, {50.0, 0.0, 0.0, 0.0}, 0.0), 0.7 * 0.02, 1e-12);
  // c = 2 d / m = 200: 4 / (200 + sqrt(200^2 + 4 * 100^2)).
  EXPECT_NEAR(stable_time_step_s(pair, pins, {50.0, 0.0, 0.0, 1.0}, 0.0), 0.7 * 4.0 / 482.842712474619,
              1e-12);
  EXPECT_TRUE(std::isinf(stable_time_step_s(pair, pins, {0.0, 0.0, 0.0, 0.0}, 0.0)));
}

// The step is stable for any stiffness and mesh, in a storm and under the pull of a hand. A step 2.5 times as long is
// unstable, except with strong damping, where the bound is cautious.
TEST(StableStep, KeepsHookesSpringsStable) {
  Surroundings storm;
  storm.forces.wind.speed_m_per_s = 20.0;
  storm.forces.wind.direction = {0.2, 0.1, 1.0};
  for (const Index columns : {9U, 15U}) {
    const Garment garment = sheet(columns);
    storm.forces.grabbed_vertices = {{columns * columns - 1, {0.3, -0.5, 0.8}, 500.0, 20.0}};
    for (const double stiffness : {200.0, 5000.0}) {
      for (const double damping : {0.0, 0.02, 0.2}) {
        SimulationSettings settings;
        const SpringStiffness springs = {stiffness, 0.5 * stiffness, 5.0, damping};
        for (const SolverMethod& method :
             {SolverMethod(ProvotSettings{springs}), SolverMethod(IdealSettings{springs})}) {
          settings.solver.method = method;
          EXPECT_FALSE(swings_up(garment, settings, storm)) << columns << ' ' << stiffness << ' ' << damping;
        }
        const double step_s = stable_time_step_s(garment, make_pins(garment, top_corners(garment)), springs,
                                                 storm.forces.air_drag_per_s);
        settings.solver.substeps = static_cast<int>(0.4 / (60.0 * step_s));
        EXPECT_TRUE(damping > 0.1 || swings_up(garment, settings, storm))
            << columns << ' ' << stiffness << ' ' << damping;
      }
    }
  }
}

TEST(StableStep, IsUsedBySolversThatChooseTheirStepsUpToALimit) {
  const Garment garment = sheet(25);
  const SpringStiffness stiff = {.structural_n_per_m = 20000.0};
  const std::vector<Index> pins = top_corners(garment);
  const double step_s = stable_time_step_s(garment, make_pins(garment, pins), stiff, 1.5);
  const auto substeps_of = [&](const SolverMethod& method, std::optional<int> substeps, int max_substeps) {
    State state = make_state(garment);
    const Pins pinned = make_pins(garment, pins);
    return make_solver({substeps, max_substeps, method})
        ->advance_frame({garment, pinned, {}, 1.0 / 60.0, {}}, state)
        .substeps;
  };
  const int needed = static_cast<int>(std::ceil(1.0 / (60.0 * step_s)));
  EXPECT_GT(needed, 100);
  EXPECT_EQ(substeps_of(IdealSettings{stiff}, {}, 2000), needed);
  EXPECT_EQ(substeps_of(ProvotSettings{stiff}, {}, 2000), needed);
  EXPECT_EQ(substeps_of(IdealSettings{stiff}, {}, 50), 50);
  EXPECT_EQ(substeps_of(IdealSettings{stiff}, 7, 2000), 7);
  EXPECT_EQ(substeps_of(StrongSettings{}, {}, 2000), 20);
  EXPECT_EQ(substeps_of(IdealSettings{{1.0, 1.0, 1.0, 0.0}}, {}, 2000), 20)
      << "soft springs need no more than they ever had";
}

}  // namespace
}  // namespace taut::sim
