#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sheets.hpp"
#include "sim/measures.hpp"

namespace taut::sim {
namespace {

Mesh one_triangle(const std::array<Vec3, 3>& corners) {
  return {{corners.begin(), corners.end()}, {{0, 1, 2}}, {}};
}

constexpr std::array<Vec3, 3> crooked = {Vec3(0.3, -0.2, 0.1), Vec3(1.1, 0.4, -0.3), Vec3(-0.2, 0.7, 0.9)};

PrincipalStretches measure_stretches(const std::array<Vec3, 3>& rest, const std::array<Vec3, 3>& now) {
  return principal_stretches(deformation_gradient(triangles_at_rest(one_triangle(rest))[0], now));
}

Vec3 turn(const Vec3& p) {
  return Vec3(0.36, 0.48, 0.8) * p.x + Vec3(-0.8, 0.6, 0.0) * p.y + Vec3(-0.48, -0.64, 0.6) * p.z;
}

TEST(Surface, TurningAndMovingStretchesNothing) {
  std::array<Vec3, 3> now;
  for (std::size_t k = 0; k < 3; ++k) {
    now[k] = turn(crooked[k]) + Vec3(5.0, -3.0, 2.0);
  }
  const PrincipalStretches stretches = measure_stretches(crooked, now);
  EXPECT_NEAR(stretches.max_ratio, 1.0, 1e-7);
  EXPECT_NEAR(stretches.min_ratio, 1.0, 1e-7);
}

TEST(Surface, LargestAndSmallestAreThoseOfAKnownMap) {
  // The map stretches by 1.3 along (3, 4) / 5 in the xy plane, and by 0.6 at right angles to it.
  const Vec3 u(0.6, 0.8, 0.0);
  const Vec3 v(-0.8, 0.6, 0.0);
  const std::array<Vec3, 3> rest = {Vec3(0.1, 0.2, 0.0), Vec3(0.9, 0.3, 0.0), Vec3(0.4, 1.1, 0.0)};
  std::array<Vec3, 3> now;
  for (std::size_t k = 0; k < 3; ++k) {
    now[k] = turn(1.3 * glm::dot(u, rest[k]) * u + 0.6 * glm::dot(v, rest[k]) * v);
  }
  const PrincipalStretches stretches = measure_stretches(rest, now);
  EXPECT_NEAR(stretches.max_ratio, 1.3, 1e-14);
  EXPECT_NEAR(stretches.min_ratio, 0.6, 1e-14);
}

TEST(Surface, GrowsAcrossEdgesThatOnlyShorten) {
  const double half_base = 0.5;
  const double side = std::sqrt(half_base * half_base + 1.0);
  const std::array<Vec3, 3> rest = {Vec3(-half_base, 0, 0), Vec3(half_base, 0, 0), Vec3(0, 1, 0)};
  const std::array<Vec3, 3> now = {Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, side, 0)};
  const Garment garment = make_garment(one_triangle(rest));
  EXPECT_NEAR(measure_stretch(garment.springs, now).max, 0.0, 1e-15);
  EXPECT_NEAR(measure_surface_stretch(garment, now).max, side - 1.0, 1e-14);
}

TEST(Surface, NoEdgeIsStretchedMoreThanItsTriangle) {
  const Garment garment = make_garment(irregular_sheet(12, 1.0));
  std::vector<Vec3> now = garment.mesh.positions;
  for (std::size_t v = 0; v < now.size(); ++v) {
    const auto phase = static_cast<double>(v);
    now[v] += 0.02 * Vec3(std::sin(phase), std::cos(3.0 * phase), std::sin(5.0 * phase));
  }
  const double edges = measure_stretch(garment.springs, now).max;
  const SurfaceStretch surface = measure_surface_stretch(garment, now);
  EXPECT_GE(surface.max, edges);
  EXPECT_GT(edges, 0.1);
  EXPECT_LE(surface.p99, surface.max);
  const std::vector<double> at_vertices = vertex_surface_stretch(garment, now);
  EXPECT_EQ(*std::max_element(at_vertices.begin(), at_vertices.end()), surface.max);
}

TEST(Surface, NinetyNineOfAHundredTrianglesAreAtOrBelowThePercentile) {
  // 200 triangles side by side, the k-th of them as high as 1 + k / 1000.
  Mesh mesh;
  std::vector<Vec3> now;
  for (Index k = 0; k < 200; ++k) {
    const double x = 2.0 * k;
    for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)}) {
      mesh.positions.push_back(p);
      now.push_back({p.x, p.y * (1.0 + 0.001 * k), p.z});
    }
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const SurfaceStretch stretch = measure_surface_stretch(make_garment(mesh), now);
  EXPECT_NEAR(stretch.max, 0.199, 1e-12);
  EXPECT_NEAR(stretch.p99, 0.197, 1e-12);
}

TEST(Surface, NeedlesHaveNone) {
  const std::array<Vec3, 3> needle = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.0009, 0)};
  const std::array<Vec3, 3> thin = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.0011, 0)};
  EXPECT_FALSE(triangles_at_rest(one_triangle(needle))[0].has_surface());
  EXPECT_TRUE(triangles_at_rest(one_triangle(thin))[0].has_surface());
  const Garment garment = make_garment(one_triangle(needle));
  const std::array<Vec3, 3> torn = {Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(0, 9, 0)};
  EXPECT_EQ(measure_surface_stretch(garment, torn).max, 0.0);
  EXPECT_EQ(vertex_surface_stretch(garment, torn), std::vector<double>(3, 0.0));
}

TEST(Surface, TheWarpRunsAlongTheSecondTextureCoordinate) {
  const Mesh mesh = {{{0.0, 0.0, 0.0}, {2.0, 1.0, 0.0}, {0.5, 2.0, 0.0}}, {{0, 1, 2}}, {}};
  const auto warp_in_space = [&](const std::vector<glm::vec2>& coordinates) {
    const Vec2 warp = warps_from_coordinates(mesh, coordinates)[0];
    const Vec3 first = glm::normalize(mesh.positions[1]);
    return warp.x * first + warp.y * glm::cross(Vec3(0.0, 0.0, 1.0), first);
  };
  EXPECT_NEAR(std::abs(warp_in_space({{0, 0}, {2, 1}, {0.5, 2}}).y), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(warp_in_space({{0, 0}, {1, -2}, {2, -0.5}}).x), 1.0, 1e-6);
  EXPECT_NEAR(warp_in_space({{0, 0}, {0, 0}, {0, 0}}).y, 1.0, 1e-12) << "upright, where they say nothing";
}

}  // namespace
}  // namespace taut::sim
