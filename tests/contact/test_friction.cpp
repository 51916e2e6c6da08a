#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scenes.hpp"

namespace taut::sim {
namespace {

constexpr double gravity_m_per_s2 = 9.81;

Vec3 middle_of(const Simulation& simulation) {
  Vec3 sum(0.0);
  for (const Vec3& p : simulation.state().current) {
    sum += p;
  }
  return sum / static_cast<double>(simulation.state().current.size());
}

/// A sheet that lies on level ground, where gravity is that of a slope. Returns how far it is after `frames`.
double slid_m(double slope, double friction, int frames) {
  ContactScene scene = {.mesh = mesh_of({.at_m = {0.0, 0.0011, 0.0}})};
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  scene.surroundings.forces.gravity_m_per_s2 = gravity_m_per_s2 * cosine * Vec3(slope, -1.0, 0.0);
  scene.surroundings.forces.air_drag_per_s = 0.0;
  scene.surroundings.bodies = {{.name = "slope", .shape = Plane{}, .friction = friction}};
  Simulation simulation = begin(std::move(scene));
  const Vec3 before_m = middle_of(simulation);
  for (int frame = 0; frame < frames; ++frame) {
    simulation.advance_frame();
  }
  return middle_of(simulation).x - before_m.x;
}

class Slope : public testing::TestWithParam<double> {};

TEST_P(Slope, HoldsAsheetThatIsLessSteepThanItsFriction) {
  EXPECT_LT(std::abs(slid_m(0.95 * GetParam(), GetParam(), 60)), 5e-4);
}

TEST_P(Slope, LetsASheetSlideThatIsSteeperAsCoulombSays) {
  const double friction = GetParam();
  const double slope = 1.3 * friction;
  const double acceleration = gravity_m_per_s2 * (slope - friction) / std::sqrt(1.0 + slope * slope);
  EXPECT_NEAR(slid_m(slope, friction, 60), 0.5 * acceleration, 0.05 * 0.5 * acceleration);
}

INSTANTIATE_TEST_SUITE_P(Friction, Slope, testing::Values(0.1, 0.3, 0.8));

TEST(Friction, ABallThatTurnsTakesClothAlong) {
  ContactScene scene = {.mesh = mesh_of({.columns = 15, .rows = 15, .at_m = {0.003, 0.152, 0.002}})};
  scene.surroundings.bodies = {{.name = "ball",
                                .shape = Sphere{{}, 0.15},
                                .motion = {.spin = {{}, {0.0, 1.0, 0.0}, 0.25, 0.5}},
                                .friction = 0.5}};
  Simulation simulation = begin(std::move(scene));
  for (int frame = 0; frame < 30; ++frame) {
    simulation.advance_frame();
  }
  // A vertex near the top, a little off the axis.
  const Index vertex = 7 * 15 + 9;
  const Vec3 before_m = simulation.state().current[vertex];
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  const Vec3 after_m = simulation.state().current[vertex];
  const double turned = std::atan2(before_m.x * after_m.z - before_m.z * after_m.x,
                                   before_m.x * after_m.x + before_m.z * after_m.z);
  // It begins to turn at once, and the cloth slides until it is as fast.
  EXPECT_GT(-turned, 0.8 * 0.25 * 6.283185307);
  EXPECT_LT(-turned, 0.25 * 6.283185307);
}

}  // namespace
}  // namespace taut::sim
