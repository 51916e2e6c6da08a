#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

/// A spring of 1 m between masses of 1 and 3 kg.
Garment pair() {
  Garment garment;
  garment.mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  garment.masses_kg = {1.0, 3.0};
  garment.springs.ends = {{0, 1}};
  garment.springs.rest_lengths_m = {1.0};
  garment.springs.structural_count = 1;
  return garment;
}

/// Returns the predicted motion of the masses after the modification of velocities.
std::vector<Vec3> modify(double length_m, const std::vector<Vec3>& moved_m, std::vector<Index> pins = {}) {
  const Garment garment = pair();
  State state = make_state(garment);
  state.current[1] = {length_m, 0, 0};
  state.predicted = {state.current[0] + moved_m[0], state.current[1] + moved_m[1]};
  VelocityModification({{}, 0.1}).compensate(garment, make_pins(garment, std::move(pins)), state);
  return {state.predicted[0] - state.current[0], state.predicted[1] - state.current[1]};
}

const std::vector<Vec3> parting = {{-0.02, 0.03, 0}, {0.06, 0, 0.01}};

TEST(Vassilev, EndsOfALongSpringPartNoFurtherAndKeepTheirMomentum) {
  const std::vector<Vec3> moved = modify(1.2, parting);
  EXPECT_NEAR(moved[1].x - moved[0].x, 0.0, 1e-15);
  EXPECT_NEAR(1.0 * moved[0].x + 3.0 * moved[1].x, 1.0 * parting[0].x + 3.0 * parting[1].x, 1e-15);
  EXPECT_NEAR(moved[0].y, parting[0].y, 1e-15) << "across the spring nothing changes";
  EXPECT_NEAR(moved[1].z, parting[1].z, 1e-15);
}

TEST(Vassilev, LeavesSpringsBelowTheThresholdAndThoseThatShorten) {
  const std::vector<Vec3> below = modify(1.09, parting);
  EXPECT_NEAR(below[0].x, parting[0].x, 1e-15);
  EXPECT_NEAR(below[1].x, parting[1].x, 1e-15);
  const std::vector<Vec3> closing = modify(1.2, {{0.02, 0, 0}, {0.01, 0, 0}});
  EXPECT_NEAR(closing[0].x, 0.02, 1e-15);
  EXPECT_NEAR(closing[1].x, 0.01, 1e-15);
}

TEST(Vassilev, APinnedEndStaysAndStopsTheOther) {
  const std::vector<Vec3> moved = modify(1.2, {{0, 0, 0}, {0.06, 0, 0.01}}, {0});
  EXPECT_EQ(moved[0], Vec3(0.0));
  EXPECT_NEAR(moved[1].x, 0.0, 1e-15);
}

TEST(Vassilev, StretchesLessThanIdealSpringsOfTheSameStiffness) {
  const Garment cloth = make_garment(make_grid({}));
  const SpringStiffness soft = {.structural_n_per_m = 8.0, .shear_n_per_m = 4.0};
  std::vector<double> stretch;
  for (const SolverMethod& method :
       {SolverMethod(IdealSettings{soft}), SolverMethod(VassilevSettings{soft, 0.05})}) {
    SimulationSettings settings;
    settings.solver.method = method;
    Simulation simulation(share(cloth), {0, 8}, settings, {});
    double worst = 0.0;
    for (int frame = 0; frame < 120; ++frame) {
      simulation.advance_frame();
      worst = std::max(worst, measure_stretch(cloth.springs, simulation.state().current).max);
    }
    stretch.push_back(worst);
  }
  EXPECT_GT(stretch[0], 0.4);
  EXPECT_LT(stretch[1], 0.7 * stretch[0]);
}

}  // namespace
}  // namespace taut::sim
