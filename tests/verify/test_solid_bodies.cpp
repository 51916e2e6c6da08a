#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "app/verify/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

Corners wide_triangle_at(double height_m) {
  return {Vec3(-1.0, height_m, -1.0), Vec3(1.0, height_m, -1.0), Vec3(0.0, height_m, 1.0)};
}

TEST(SolidBodies, OfAPlaneTheCornersDecide) {
  const Vec3 point(0.0, 0.2, 0.0), up(0.0, 1.0, 0.0);
  EXPECT_FALSE(enters_half_space(wide_triangle_at(0.2), point, up));
  EXPECT_TRUE(enters_half_space(wide_triangle_at(0.2 - 2e-9), point, up));
  Corners tilted = wide_triangle_at(0.3);
  tilted[1].y = 0.1;
  EXPECT_TRUE(enters_half_space(tilted, point, up));
}

// The triangle is so wide that no corner and no edge is near.
TEST(SolidBodies, AreEnteredInTheMiddleOfATriangle) {
  const LimbShape ball = {Vec3(0.0), Vec3(0.0), 0.1, 0.1};
  EXPECT_TRUE(enters_limb(wide_triangle_at(0.1 - 2e-9), ball));
  EXPECT_FALSE(enters_limb(wide_triangle_at(0.1 + 2e-9), ball));
  const LimbShape lying = {Vec3(-0.3, 0.0, 0.0), Vec3(0.3, 0.0, 0.0), 0.1, 0.1};
  EXPECT_TRUE(enters_limb(wide_triangle_at(0.1 - 2e-9), lying));
  EXPECT_FALSE(enters_limb(wide_triangle_at(0.1 + 2e-9), lying));
  const LimbShape standing = {Vec3(0.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0), 0.02, 0.02};
  EXPECT_TRUE(enters_limb(wide_triangle_at(0.0), standing)) << "pierced by it";
  EXPECT_TRUE(enters_limb({Vec3(0.01), Vec3(0.011), Vec3(0.01, 0.011, 0.01)}, standing)) << "inside it";
  EXPECT_FALSE(enters_limb({Vec3(0.1), Vec3(0.3), Vec3(0.1, 0.3, 0.1)}, standing));
}

/// Distance of a point from the limb's surface, by the definition of a limb; negative inside.
double outside_m(const Vec3& p, const LimbShape& limb) {
  const Vec3 axis = limb.end_m - limb.start_m;
  const double at = std::clamp(glm::dot(p - limb.start_m, axis) / glm::dot(axis, axis), 0.0, 1.0);
  return glm::distance(p, limb.start_m + at * axis) - glm::mix(limb.start_radius_m, limb.end_radius_m, at);
}

TEST(SolidBodies, AreEnteredWhereAnyPointOfATriangleIsInTheLimb) {
  std::mt19937 random(5);  // NOLINT: the same triangles in every run
  std::uniform_real_distribution<double> coordinate(-0.3, 0.3), side(-0.1, 0.1);
  const LimbShape limb = {Vec3(-0.2, 0.0, 0.05), Vec3(0.15, 0.1, 0.0), 0.04, 0.13};
  constexpr int fine = 40;
  int in = 0, out = 0;
  // Braces fix the order of the three numbers.
  const auto any = [&](auto& distribution) {
    return Vec3{distribution(random), distribution(random), distribution(random)};
  };
  for (int i = 0; i < 3000; ++i) {
    Corners t;
    t[0] = any(coordinate);
    t[1] = t[0] + any(side);
    t[2] = t[0] + any(side);
    double min_distance_m = 1.0;
    for (int u = 0; u <= fine; ++u) {
      for (int v = 0; u + v <= fine; ++v) {
        const Vec3 p = t[0] + (t[1] - t[0]) * (1.0 * u / fine) + (t[2] - t[0]) * (1.0 * v / fine);
        min_distance_m = std::min(min_distance_m, outside_m(p, limb));
      }
    }
    const bool enters = enters_limb(t, limb);
    // The triangle may be nearer between the sampled points: by at most their distance, and somewhat more as the limb
    // widens along its axis.
    const double max_length_m =
        std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
    ASSERT_TRUE(enters ? min_distance_m < 1.1 * max_length_m / fine : min_distance_m >= -max_depth_m) << i;
    ++(enters ? in : out);
  }
  EXPECT_GT(in, 300);
  EXPECT_GT(out, 300);
}

TEST(SolidBodies, AreGoneAroundOnceWithinAndNotOutside) {
  const std::vector<Vec3> corners_m = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const std::vector<sim::Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const sim::Surface outwards = {corners_m, faces};
  EXPECT_NEAR(sim::winding_number({0.2, 0.2, 0.2}, outwards), 1.0, 1e-12);
  EXPECT_NEAR(sim::winding_number({1e-6, 0.3, 0.3}, outwards), 1.0, 1e-9) << "just within a face";
  EXPECT_NEAR(sim::winding_number({-1e-6, 0.3, 0.3}, outwards), 0.0, 1e-9) << "just outside it";
  EXPECT_NEAR(sim::winding_number({0.5, 0.5, 0.5}, outwards), 0.0, 1e-12);
  const std::vector<sim::Triangle> inside_out = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  EXPECT_NEAR(sim::winding_number({0.2, 0.2, 0.2}, {corners_m, inside_out}), -1.0, 1e-12);
}

}  // namespace
}  // namespace taut::app
