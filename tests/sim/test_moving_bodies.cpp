#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/contact/bodies.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

/// A quarter of a turn in a second about the z axis, and a metre towards +z.
const RigidMotion quarter = {.shift = {{0.0, 0.0, 1.0}, 0.0, 1.0},
                             .spin = {{}, {0.0, 0.0, 1.0}, 0.25, 0.0, 1.0}};

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_LT(glm::length(found - expected), 1e-14) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(MovingBodies, TakeTheirShapesAlong) {
  const auto plane =
      std::get<Plane>(shape_at({.shape = Plane{{1, 0, 0}, {1, 0, 0}}, .motion = quarter}, 1.0));
  expect_near(plane.point_m, {0, 1, 1});
  expect_near(plane.normal, {0, 1, 0});
  const auto ball = std::get<Sphere>(shape_at({.shape = Sphere{{1, 0, 0}, 0.5}, .motion = quarter}, 1.0));
  expect_near(ball.centre_m, {0, 1, 1});
  EXPECT_EQ(ball.radius_m, 0.5);
  const Capsule modelled{{1, 0, 0}, {2, 0, 0}, 0.1, 0.2};
  const auto limb = std::get<Capsule>(shape_at({.shape = modelled, .motion = quarter}, 1.0));
  expect_near(limb.start_m, {0, 1, 1});
  expect_near(limb.end_m, {0, 2, 1});
  EXPECT_EQ(limb.end_radius_m, 0.2);
}

std::shared_ptr<const BodyMeshData> corner() {
  return std::make_shared<const BodyMeshData>(BodyMeshData{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                           {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
}

std::vector<Vec3> body_positions(const Body& body, double time_s) {
  std::vector<Vec3> positions_m(std::get<BodyMesh>(body.shape).data->positions_m.size());
  positions_at(body, time_s, positions_m);
  return positions_m;
}

TEST(MovingBodies, AMeshIsTurnedAndMovedAsAWhole) {
  const Body body = {.shape = BodyMesh{corner()}, .motion = quarter};
  EXPECT_EQ(body_positions(body, 0.0), corner()->positions_m);
  const std::vector<Vec3> later = body_positions(body, 1.0);
  expect_near(later[1], {0, 1, 1});
  expect_near(later[2], {-1, 0, 1});
  EXPECT_FALSE(is_moving_after(body, 1.0));
  EXPECT_TRUE(is_moving_after(body, 0.9));
}

class ListedFrames : public BodyFrames {
 public:
  ListedFrames(double rate_hz, std::vector<std::vector<Vec3>> frames)
      : rate_hz_(rate_hz), frames_(std::move(frames)) {}
  std::size_t count() const override { return frames_.size(); }
  double rate_hz() const override { return rate_hz_; }
  void positions_in(std::size_t frame, std::span<Vec3> positions_m) const override {
    std::copy(frames_.at(frame).begin(), frames_.at(frame).end(), positions_m.begin());
  }

 private:
  double rate_hz_;
  std::vector<std::vector<Vec3>> frames_;
};

TEST(MovingBodies, AMeshGoesThroughItsFramesAndIsHeldInTheLast) {
  std::vector<Vec3> grown = corner()->positions_m;
  for (Vec3& position_m : grown) {
    position_m *= 3.0;
  }
  const auto frames = std::make_shared<const ListedFrames>(
      2.0, std::vector{corner()->positions_m, grown, corner()->positions_m});
  const Body body = {.shape = BodyMesh{corner(), frames}};
  EXPECT_EQ(body_positions(body, 0.0), corner()->positions_m);
  EXPECT_EQ(body_positions(body, 0.25)[1], Vec3(2, 0, 0));
  EXPECT_EQ(body_positions(body, 0.5), grown);
  EXPECT_EQ(body_positions(body, 9.0), corner()->positions_m);
  EXPECT_TRUE(is_moving_after(body, 0.9));
  EXPECT_FALSE(is_moving_after(body, 1.0));
  EXPECT_EQ(body_positions({.shape = BodyMesh{corner(), frames}, .motion = {.shift = {{1, 0, 0}}}}, 0.5)[1],
            Vec3(3.5, 0, 0))
      << "its frames move with it";
}

TEST(MovingBodies, MeshesAreEqualIfTheyShareTheirArrays) {
  const auto data = corner();
  EXPECT_EQ((Body{.shape = BodyMesh{data}}), (Body{.shape = BodyMesh{data}}));
  EXPECT_NE((Body{.shape = BodyMesh{data}}), (Body{.shape = BodyMesh{corner()}}));
}

TEST(MovingBodies, PushClothOutOfWhereTheyAreAtTheEndOfTheStep) {
  const std::vector<Body> rising = {{.shape = Plane{}, .motion = {.shift = {{0, 1, 0}}}, .friction = 0.0}};
  const std::vector<Vec3> current = {{0, 0.5, 0}};
  std::vector<Vec3> predicted = {{0, 0.45, 0}};
  push_out_of_bodies(rising, {}, {0.5, 0.6}, std::vector{1.0}, current, predicted);
  EXPECT_NEAR(predicted[0].y, 0.6, 1e-15);
}

TEST(MovingBodies, DragClothThatRestsOnThemByFriction) {
  const std::vector<Body> conveyor = {{.shape = Plane{}, .motion = {.shift = {{2, 0, 0}}}, .friction = 0.5}};
  const std::vector<Vec3> current = {{0, 0, 0}, {1, 0, 0}};
  std::vector<Vec3> predicted = {{0, -0.02, 0}, {1, -1.0, 0}};
  push_out_of_bodies(conveyor, {}, {0.5, 0.6}, std::vector{1.0, 1.0}, current, predicted);
  EXPECT_NEAR(predicted[0].x, 0.01, 1e-15) << "mu times depth";
  EXPECT_NEAR(predicted[1].x, 1.2, 1e-15) << "held: as far as the body";
}

TEST(MovingBodies, ATurningBallTakesAPointOnItsTopAlong) {
  const Body ball = {.shape = Sphere{{0, 0, 0}, 0.5}, .motion = {.spin = {{}, {0, 1, 0}, 0.25}}};
  expect_near(point_moved(ball, {0, 0.3, 0.4}, {0.0, 1.0}), {0.4, 0.3, 0});
  expect_near(point_moved(ball, {0.4, 0.3, 0}, {1.0, 0.0}), {0, 0.3, 0.4});
}

class EverySolver : public testing::TestWithParam<SolverMethod> {};

INSTANTIATE_TEST_SUITE_P(MovingBodies, EverySolver,
                         testing::Values(SolverMethod(StrongSettings{}), SolverMethod(BoundedSettings{})));

TEST_P(EverySolver, LiesOnAConveyorThatCarriesItAndFallsAsleepWhenThatStops) {
  GridSettings grid;
  grid.columns = grid.rows = 5;
  grid.plane = GridPlane::horizontal;
  grid.top_centre_m = {0, 0.001, -0.5};
  Surroundings surroundings;
  surroundings.bodies = {{.shape = Plane{}, .motion = {.shift = {{0.5, 0, 0}, 0.5, 1.5}}, .friction = 1.0}};
  SimulationSettings settings;
  settings.solver.method = GetParam();
  Simulation simulation(share(make_garment(make_grid(grid))), {}, settings, surroundings);
  const std::vector<Vec3> before = simulation.state().current;
  for (int frame = 0; frame < 90; ++frame) {
    simulation.advance_frame();
    ASSERT_FALSE(simulation.state().asleep) << frame;
  }
  for (int frame = 90; frame < 300; ++frame) {
    simulation.advance_frame();
  }
  EXPECT_TRUE(simulation.state().asleep);
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_NEAR(simulation.state().current[v].x - before[v].x, 0.5, 0.01) << v;
  }
}

TEST_P(EverySolver, IsPushedAlongByACapsule) {
  GridSettings grid;
  grid.columns = grid.rows = 13;
  grid.top_centre_m = {0, 1, 0};
  Surroundings surroundings;
  surroundings.bodies = {{.shape = Capsule{{-1, 0.3, -0.3}, {1, 0.3, -0.3}, 0.1, 0.1},
                          .motion = {.shift = {{0, 0, 0.5}, 0.0, 1.0}}}};
  SimulationSettings settings;
  settings.solver.method = GetParam();
  Simulation simulation(share(make_garment(make_grid(grid))), {0, 6, 12}, settings, surroundings);
  for (int frame = 0; frame < 90; ++frame) {
    simulation.advance_frame();
    const auto limb = std::get<Capsule>(shape_at(surroundings.bodies[0], simulation.state().time_s));
    for (const Vec3& p : simulation.state().current) {
      EXPECT_GT(nearest_surface(limb, p).distance_m, 0.0) << frame;
    }
  }
  // The row at the capsule's height hangs in front of it.
  for (std::size_t v = std::size_t{8} * 13; v < std::size_t{9} * 13; ++v) {
    EXPECT_GT(simulation.state().current[v].z, 0.25) << v;
  }
}

}  // namespace
}  // namespace taut::sim
