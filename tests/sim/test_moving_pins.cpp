#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

constexpr Index columns = 9;
constexpr Index rows = 17;

std::shared_ptr<const Garment> band() {
  GridSettings grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.width_m = 0.5;
  grid.top_centre_m = {0, 1, 0};
  return share(make_garment(make_grid(grid)));
}

std::vector<Index> row(Index r) {
  std::vector<Index> vertices;
  for (Index c = 0; c < columns; ++c) {
    vertices.push_back(r * columns + c);
  }
  return vertices;
}

std::vector<Index> both_ends() {
  std::vector<Index> ends = row(0);
  const std::vector<Index> lower = row(rows - 1);
  ends.insert(ends.end(), lower.begin(), lower.end());
  return ends;
}

/// The ends turn against each other about the band's middle line and approach.
Surroundings twist(double turns_per_s) {
  Surroundings surroundings;
  surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  surroundings.moving_pins = {
      {row(0), {.shift = {{0, -0.2, 0}, 0, 1}, .spin = {{}, {0, 1, 0}, turns_per_s, 0, 1}}},
      {row(rows - 1), {.shift = {{0, 0.2, 0}, 0, 1}, .spin = {{}, {0, 1, 0}, -turns_per_s, 0, 1}}}};
  return surroundings;
}

class MovingPinsOf : public testing::TestWithParam<SolverMethod> {};

INSTANTIATE_TEST_SUITE_P(Solvers, MovingPinsOf,
                         testing::Values(SolverMethod(StrongSettings{}), SolverMethod(BoundedSettings{})));

TEST_P(MovingPinsOf, EachGroupGoesItsOwnWayAndTheClothBetweenFollows) {
  SimulationSettings settings;
  settings.solver.method = GetParam();
  const auto garment = band();
  const std::vector<Vec3>& modelled = garment->mesh.positions;
  const Surroundings surroundings = twist(0.25);
  Simulation simulation(garment, both_ends(), settings, surroundings);
  for (int frame = 0; frame < 75; ++frame) {
    simulation.advance_frame();
    EXPECT_TRUE(simulation.frame_report().bound_kept) << frame;
    for (const MovingPins& group : surroundings.moving_pins) {
      const Pose pose = pose_at(group.motion, simulation.state().time_s);
      for (const Index pin : group.vertices) {
        ASSERT_LT(glm::distance(simulation.state().current[pin], pose(modelled[pin])), 1e-12) << frame;
      }
    }
  }
  const Vec3 left = simulation.state().current[0] - simulation.state().current[columns - 1];
  EXPECT_NEAR(std::abs(left.z), 0.5, 1e-12) << "a quarter of a turn";
  const Vec3 middle = simulation.state().current[(rows / 2) * columns];
  EXPECT_LT(glm::length(middle - modelled[(rows / 2) * columns]), 0.2) << "halfway between opposite turns";
}

TEST_P(MovingPinsOf, TheOthersSwingAsBefore) {
  SimulationSettings settings;
  settings.solver.method = GetParam();
  const auto garment = band();
  Surroundings surroundings;
  surroundings.pin_motion = {{0.0, 0.0, 0.03}, 1.0};
  surroundings.moving_pins = {{row(rows - 1), {.path = {{0.0, {}}, {1.0, {0.0, 0.1, 0.0}}}}}};
  Simulation simulation(garment, both_ends(), settings, surroundings);
  for (int frame = 0; frame < 15; ++frame) {  // a quarter of a period
    simulation.advance_frame();
  }
  const Index below = (rows - 1) * columns;
  EXPECT_LT(glm::distance(simulation.state().current[0], garment->mesh.positions[0] + Vec3(0, 0, 0.03)),
            1e-12);
  EXPECT_LT(
      glm::distance(simulation.state().current[below], garment->mesh.positions[below] + Vec3(0, 0.025, 0)),
      1e-12);
}

TEST(MovingPins, KeepClothAwakeUntilTheLastHasStopped) {
  const Surroundings surroundings = twist(0.1);
  EXPECT_FALSE(is_steady(surroundings, 0.99));
  EXPECT_TRUE(is_steady(surroundings, 1.0));
}

TEST(MovingPins, MustBeVerticesInAscendingOrder) {
  Surroundings surroundings;
  surroundings.moving_pins = {{{3, 7}}};
  require_possible(surroundings, 8);
  EXPECT_THROW(require_possible(surroundings, 7), std::invalid_argument);
  surroundings.moving_pins = {{{7, 3}}};
  EXPECT_THROW(require_possible(surroundings, 8), std::invalid_argument);
}

TEST_P(MovingPinsOf, ThoseThatAreLedGoStraightToPlacesOfTheirOwnAndStay) {
  SimulationSettings settings;
  settings.solver.method = GetParam();
  const auto garment = band();
  const std::vector<Vec3>& modelled = garment->mesh.positions;
  Surroundings surroundings;
  surroundings.pin_motion = {{0.0, 0.0, 0.002}, 1.0};
  surroundings.prescribed_pins = {{0, columns - 1}, {{0.0, 0.004, 0.0}, {-0.002, 0.0, 0.0}}, 0.0, 4.0 / 60.0};
  Simulation simulation(garment, row(0), settings, surroundings);
  for (int frame = 1; frame <= 6; ++frame) {
    simulation.advance_frame();
    const double share = std::min(frame / 4.0, 1.0);
    const std::vector<Vec3>& now = simulation.state().current;
    EXPECT_LT(glm::distance(now[0], modelled[0] + share * Vec3(0.0, 0.004, 0.0)), 1e-9) << frame;
    EXPECT_LT(glm::distance(now[columns - 1], modelled[columns - 1] + share * Vec3(-0.002, 0.0, 0.0)), 1e-9);
    EXPECT_GT(now[1].z, modelled[1].z) << "the others swing";
  }
}

TEST(MovingPins, ThoseThatAreLedKeepClothAwakeAndNeedAWayAndATime) {
  Surroundings surroundings;
  surroundings.prescribed_pins = {{3, 7}, {Vec3(0.1), Vec3(0.0)}, 1.0, 2.0};
  require_possible(surroundings, 8);
  EXPECT_FALSE(is_steady(surroundings, 0.5));
  EXPECT_TRUE(is_steady(surroundings, 2.0));
  EXPECT_THROW(require_possible(surroundings, 7), std::invalid_argument);
  const auto expect_refused = [&](const PrescribedPins& led) {
    surroundings.prescribed_pins = led;
    EXPECT_THROW(require_possible(surroundings, 8), std::invalid_argument);
  };
  expect_refused({{7, 3}, {Vec3(0.1), Vec3(0.0)}, 1.0, 2.0});
  expect_refused({{3, 7}, {Vec3(0.1)}, 1.0, 2.0});
  expect_refused({{3, 7}, {Vec3(0.1), Vec3(0.0)}, 1.0, 1.0});
}

}  // namespace
}  // namespace taut::sim
