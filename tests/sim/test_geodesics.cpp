// Distances along the cloth.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "sim/mesh/geodesics.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::sim {
namespace {

Mesh sheet(Index columns, Index rows, double width_m, double height_m) {
  GridSettings grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.width_m = width_m;
  grid.height_m = height_m;
  return make_grid(grid);
}

GeodesicDistances distances(const Mesh& mesh, const std::vector<Index>& sources) {
  return geodesic_distances(mesh, make_adjacency(mesh), sources);
}

TEST(Geodesics, AreStraightLinesOnFlatCloth) {
  const Mesh mesh = sheet(9, 13, 0.7, 1.1);
  const Index corner = 0;
  const GeodesicDistances found = distances(mesh, {corner});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(found.distances_m[v], glm::length(mesh.positions[v] - mesh.positions[corner]), 1e-12);
    EXPECT_EQ(found.nearest_sources[v], corner);
  }
}

TEST(Geodesics, RollingClothUpDoesNotBringItsEndsNearer) {
  Mesh mesh = sheet(61, 9, 1.2, 0.2);
  const GeodesicDistances flat = distances(mesh, {4});
  const double radius_m = 0.2;
  for (Vec3& p : mesh.positions) {
    const double angle = p.x / radius_m;
    p = {radius_m * std::sin(angle), p.y, radius_m * std::cos(angle)};
  }
  const GeodesicDistances rolled = distances(mesh, {4});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(rolled.distances_m[v], flat.distances_m[v], 0.002 * flat.distances_m[v] + 1e-9);
  }
}

TEST(Geodesics, TheNearestOfManySourcesCounts) {
  const Mesh mesh = sheet(21, 11, 2.0, 1.0);
  const std::vector<Index> sources = {0, 20};
  const GeodesicDistances found = distances(mesh, sources);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double to_left_m = glm::length(mesh.positions[v] - mesh.positions[0]);
    const double to_right_m = glm::length(mesh.positions[v] - mesh.positions[20]);
    const double min_distance_m = std::min(to_left_m, to_right_m);
    EXPECT_GE(found.distances_m[v], min_distance_m - 1e-12);
    EXPECT_LE(found.distances_m[v], 1.01 * min_distance_m + 1e-12);
    if (std::abs(to_left_m - to_right_m) > 0.1) {
      EXPECT_EQ(found.nearest_sources[v], to_left_m < to_right_m ? 0u : 20u);
    }
  }
}

TEST(Geodesics, UnreachableVerticesAreInfinitelyFar) {
  Mesh mesh = sheet(3, 3, 1.0, 1.0);
  mesh.quads.clear();
  const auto first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{5.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, {5.0, 1.0, 0.0}});
  mesh.triangles.push_back({first, first + 1, first + 2});
  const GeodesicDistances found = distances(mesh, {0});
  EXPECT_TRUE(std::isfinite(found.distances_m[first - 1]));
  EXPECT_TRUE(std::isinf(found.distances_m[first]));
  EXPECT_EQ(found.nearest_sources[first], GeodesicDistances::no_source);
}

TEST(Geodesics, NeedlesGiveNoMoreThanTheWayAlongEdges) {
  Mesh mesh;
  mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 1e-9, 0.0}, {0.5, 0.5, 0.0}, {0.5, -0.5, 0.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 4}};
  const GeodesicDistances found = distances(mesh, {3});
  EXPECT_NEAR(found.distances_m[2], 0.5, 1e-8);
  EXPECT_GE(found.distances_m[4], 1.0 - 1e-8);
  EXPECT_LE(found.distances_m[4], std::numbers::sqrt2);
}

}  // namespace
}  // namespace taut::sim
