#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/contact/bodies.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

TEST(NearestSurface, IsAlongTheNormalOfAPlane) {
  const ShapeSurfacePoint p = nearest_surface(Plane{{0, 1, 0}, {0, 1, 0}}, {5, 3, 2});
  EXPECT_EQ(p.distance_m, 2.0);
  EXPECT_EQ(p.normal, Vec3(0, 1, 0));
}

TEST(NearestSurface, IsAwayFromTheCentreOfASphere) {
  const Sphere sphere{{1, 0, 0}, 0.5};
  EXPECT_EQ(nearest_surface(sphere, {3, 0, 0}).distance_m, 1.5);
  EXPECT_EQ(nearest_surface(sphere, {1, 0.25, 0}).distance_m, -0.25);
  EXPECT_EQ(nearest_surface(sphere, {1, 0.25, 0}).normal, Vec3(0, 1, 0));
  EXPECT_EQ(nearest_surface(sphere, {1, 0, 0}).normal, Vec3(0, 1, 0)) << "the centre has a way out too";
}

TEST(NearestSurface, IsBesideAndBeyondTheSegmentOfACapsule) {
  const Capsule capsule{{0, 0, 0}, {0, 2, 0}, 0.5, 0.5};
  EXPECT_EQ(nearest_surface(capsule, {1, 1, 0}).distance_m, 0.5);
  EXPECT_EQ(nearest_surface(capsule, {0, 3, 0}).distance_m, 0.5);
  EXPECT_EQ(nearest_surface(capsule, {0, -1, 0}).normal, Vec3(0, -1, 0));
}

TEST(NearestSurface, FollowsTheRadiusOfATaperedCapsule) {
  const Capsule limb{{0, 0, 0}, {0, 2, 0}, 0.4, 0.2};
  EXPECT_NEAR(nearest_surface(limb, {1, 0, 0}).distance_m, 0.6, 1e-15);
  EXPECT_NEAR(nearest_surface(limb, {1, 1, 0}).distance_m, 0.7, 1e-15);
  EXPECT_NEAR(nearest_surface(limb, {1, 2, 0}).distance_m, 0.8, 1e-15);
  const Capsule ball{{0, 0, 0}, {0, 0, 0}, 0.3, 0.3};
  EXPECT_NEAR(nearest_surface(ball, {1, 0, 0}).distance_m, 0.7, 1e-15);
}

TEST(PushOut, StopsAtTheThicknessAndLeavesPinsAlone) {
  const std::vector<Body> floor = {{.shape = Plane{}, .friction = 0.0}};
  const std::vector<Vec3> current = {{0, 0.1, 0}, {1, 0.1, 0}, {2, 0.1, 0}};
  std::vector<Vec3> predicted = {{0.3, -0.2, 0}, {1, -0.2, 0}, {2, 0.05, 0}};
  push_out_of_bodies(floor, {.thickness_m = 0.01}, {}, std::vector{1.0, 0.0, 1.0}, current, predicted);
  EXPECT_NEAR(glm::length(predicted[0] - Vec3(0.3, 0.01, 0)), 0.0, 1e-15) << "without friction it slides on";
  EXPECT_EQ(predicted[1], Vec3(1, -0.2, 0));
  EXPECT_EQ(predicted[2], Vec3(2, 0.05, 0));
}

TEST(PushOut, FrictionTakesBackSlidingInProportionToDepth) {
  const std::vector<Body> floor = {{.shape = Plane{}, .friction = 0.5}};
  const std::vector<Vec3> current = {{0, 0, 0}, {1, 0, 0}};
  std::vector<Vec3> predicted = {{0.3, -0.2, 0}, {1.05, -0.2, 0}};
  push_out_of_bodies(floor, {.thickness_m = 0.0}, {}, std::vector{1.0, 1.0}, current, predicted);
  EXPECT_NEAR(predicted[0].x, 0.2, 1e-15) << "0.3 less mu times depth";
  EXPECT_NEAR(predicted[1].x, 1.0, 1e-15) << "sticks, never slides backwards";
}

/// Returns how far a single mass point slides from rest down a slope of this angle within a second.
double slid_m(double slope_rad, double friction) {
  Garment point;
  point.mesh.positions = {{0, 0, 0}};
  point.masses_kg = {0.1};
  point.material = {.areal_density_kg_per_m2 = 1.0, .thickness_m = 0.0};
  Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 0.0;
  surroundings.bodies = {
      {.shape = Plane{{0, 0, 0}, {std::sin(slope_rad), std::cos(slope_rad), 0}}, .friction = friction}};
  SimulationSettings settings;
  settings.solver.method = StrongSettings{};
  Simulation simulation(share(point), {}, settings, surroundings);
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  return glm::length(simulation.state().current[0]);
}

TEST(Friction, HoldsBelowTheAngleOfReposeAndSlidesAboveItByCoulombsLaw) {
  const double friction = 0.4;  // angle of repose: atan 0.4 = 21.8 degrees
  EXPECT_NEAR(slid_m(0.35, friction), 0.0, 1e-12);
  const double slope = 0.5;
  const double expected = 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope));
  EXPECT_NEAR(slid_m(slope, friction), expected, 0.005 * expected);
  EXPECT_NEAR(slid_m(slope, 0.0), 0.5 * 9.81 * std::sin(slope), 0.01);
}

TEST(Cloth, DrapesOverASphereWithoutEnteringIt) {
  GridSettings grid;
  grid.columns = grid.rows = 17;
  grid.plane = GridPlane::horizontal;
  grid.top_centre_m = {0, 0.4, -0.5};
  Surroundings surroundings;
  const Sphere ball{{0, 0, 0}, 0.3};
  surroundings.bodies = {{.shape = ball, .friction = 0.5},
                         {.shape = Plane{{0, -0.5, 0}, {0, 1, 0}}, .friction = 0.5}};
  Simulation simulation(share(make_garment(make_grid(grid))), {}, {}, surroundings);
  for (int frame = 0; frame < 240; ++frame) {
    simulation.advance_frame();
    for (const Vec3& p : simulation.state().current) {
      EXPECT_GE(glm::length(p), 0.3);
      EXPECT_GE(p.y, -0.5);
    }
  }
  double lowest = 1.0;
  for (const Vec3& p : simulation.state().current) {
    lowest = std::min(lowest, p.y);
  }
  EXPECT_LT(lowest, 0.0) << "its corners hang down";
}

}  // namespace
}  // namespace taut::sim
