#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/explicit_solvers.hpp"

namespace taut::sim {
namespace {

Garment row_of_three() {
  Garment row;
  row.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  row.masses_kg = {1.0, 1.0, 1.0};
  row.springs.ends = {{0, 1}, {1, 2}};
  row.springs.rest_lengths_m = {1.0, 1.0};
  row.springs.structural_count = 2;
  return row;
}

TEST(Provot, LeavesSpringsBelowTheThresholdToTheirForces) {
  const Garment row = row_of_three();
  State state = make_state(row);
  state.predicted = {{0, 0, 0}, {1.09, 0, 0}, {2.0, 0, 0}};
  const auto before = state.predicted;
  ProvotThreshold({{}, 0.1}).compensate(row, make_pins(row, {}), state);
  EXPECT_EQ(state.predicted, before);
}

TEST(Provot, PullsALongSpringBackToTheThresholdAndNoFurther) {
  const Garment row = row_of_three();
  State state = make_state(row);
  state.predicted = {{0, 0, 0}, {1.5, 0, 0}, {2.4, 0, 0}};
  ProvotThreshold({{}, 0.1}).compensate(row, make_pins(row, {0}), state);
  EXPECT_NEAR(state.predicted[1].x, 1.1 + 0.1, 1e-15) << "brought to 1.1, then stretched again by 1-2";
  EXPECT_NEAR(state.predicted[2].x, 2.3, 1e-15);
}

TEST(Provot, StretchesLessThanIdealSpringsOfTheSameStiffness) {
  const Garment cloth = make_garment(make_grid({}));
  double stretch[2];
  const SpringStiffness soft = {.structural_n_per_m = 8.0, .shear_n_per_m = 4.0};
  for (const SolverMethod& method :
       {SolverMethod(IdealSettings{soft}), SolverMethod(ProvotSettings{soft, 0.1})}) {
    SimulationSettings settings;
    settings.solver.method = method;
    Simulation simulation(share(cloth), {0, 8}, settings, {});
    for (int frame = 0; frame < 300; ++frame) {
      simulation.advance_frame();
    }
    stretch[solver_kind(method) == SolverKind::provot] = measure_stretch(cloth.springs, simulation.state().current).max;
  }
  EXPECT_GT(stretch[0], 0.25);
  EXPECT_LT(stretch[1], 0.15);
  EXPECT_GT(stretch[1], 0.09);
}

}  // namespace
}  // namespace taut::sim
