#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scenes.hpp"

namespace taut::sim {
namespace {

constexpr double gravity_m_per_s2 = 9.81;

Vec3 compute_middle(const Simulation& simulation) {
  Vec3 sum(0.0);
  for (const Vec3& p : simulation.state().current) {
    sum += p;
  }
  return sum / static_cast<double>(simulation.state().current.size());
}

/// Returns how far a sheet on level ground slides in this many frames under the gravity of a slope.
double slid_m(double slope, double friction, int frames) {
  ContactScene scene = {.mesh = make_mesh({.at_m = {0.0, 0.0011, 0.0}})};
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  scene.surroundings.forces.gravity_m_per_s2 = gravity_m_per_s2 * cosine * Vec3(slope, -1.0, 0.0);
  scene.surroundings.forces.air_drag_per_s = 0.0;
  scene.surroundings.bodies = {{.name = "slope", .shape = Plane{}, .friction = friction}};
  Simulation simulation = begin(std::move(scene));
  const Vec3 before_m = compute_middle(simulation);
  for (int frame = 0; frame < frames; ++frame) {
    simulation.advance_frame();
  }
  return compute_middle(simulation).x - before_m.x;
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

/// Returns the angle in rad by which cloth on a turning ball turns within a second.
double turned_by_ball(double aside_m) {
  ContactScene scene = {.mesh = make_mesh({.columns = 15, .rows = 15, .at_m = {aside_m, 0.152, 0.002}})};
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
  return -std::atan2(before_m.x * after_m.z - before_m.z * after_m.x,
                     before_m.x * after_m.x + before_m.z * after_m.z);
}

// The ball begins to turn abruptly, and the cloth slides until it is as fast, longer from some starts.
TEST(Friction, ABallThatTurnsTakesClothAlong) {
  const double quarter = 0.25 * 6.283185307;
  double sum = 0.0;
  const std::array starts_m = {0.001, 0.002, 0.003, 0.004, 0.005};
  for (const double aside_m : starts_m) {
    const double turned = turned_by_ball(aside_m);
    EXPECT_GT(turned, 0.75 * quarter) << aside_m;
    EXPECT_LT(turned, quarter) << aside_m;
    sum += turned;
  }
  EXPECT_GT(sum / starts_m.size(), 0.8 * quarter);
}

}  // namespace
}  // namespace taut::sim
