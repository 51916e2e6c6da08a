// Points that follow a mesh to which they are bound.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

/// A level sheet of 1 m at this height, which faces up.
sim::Mesh sheet(int columns, double height_m = 0.0) {
  sim::Mesh mesh;
  for (int z = 0; z <= columns; ++z) {
    for (int x = 0; x <= columns; ++x) {
      mesh.positions.emplace_back(double(x) / columns, height_m, double(z) / columns);
    }
  }
  const auto at = [&](int x, int z) { return static_cast<sim::Index>(z * (columns + 1) + x); };
  for (int z = 0; z < columns; ++z) {
    for (int x = 0; x < columns; ++x) {
      mesh.triangles.push_back({at(x, z), at(x, z + 1), at(x + 1, z)});
      mesh.triangles.push_back({at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)});
    }
  }
  return mesh;
}

Vec3 wave(const Vec3& p) { return {p.x, p.y + 0.1 * std::sin(5.0 * p.x) * std::cos(4.0 * p.z), p.z}; }

template <class Move> std::vector<Vec3> translate(const std::vector<Vec3>& points, Move move) {
  std::vector<Vec3> result;
  for (const Vec3& p : points) {
    result.push_back(move(p));
  }
  return result;
}

double max_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    largest = std::max(largest, glm::distance(a[k], b[k]));
  }
  return largest;
}

/// Points on, above and below the sheet, and beyond its border.
std::vector<Vec3> points_about() {
  std::vector<Vec3> points;
  for (int k = 0; k < 200; ++k) {
    points.emplace_back(1.1 * std::fmod(0.618 * k, 1.0) - 0.05, 0.01 * (k % 5 - 2),
                        1.1 * std::fmod(0.414 * k, 1.0) - 0.05);
  }
  return points;
}

TEST(Following, AMeshThatFollowsItselfMovesWithIt) {
  const sim::Mesh mesh = sheet(12);
  const std::vector<Bond> bonds = bonds_to(mesh.positions, mesh);
  const std::vector<Vec3> waves = translate(mesh.positions, wave);
  EXPECT_LT(max_distance(follow(bonds, waves, mesh.triangles), waves), 1e-9);
}

TEST(Following, PointsStayWhereTheMeshWasWhenTheyWereBound) {
  sim::Mesh mesh = sheet(12);
  mesh.positions = translate(mesh.positions, wave);
  const std::vector<Vec3> points = points_about();
  EXPECT_LT(max_distance(follow(bonds_to(points, mesh), mesh.positions, mesh.triangles), points), 1e-9);
}

TEST(Following, PointsTurnWithTheMesh) {
  sim::Mesh mesh = sheet(12);
  mesh.positions = translate(mesh.positions, wave);
  const auto turn = [](const Vec3& p) {
    return Vec3(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z) + Vec3(3.0, 1.0, -2.0);
  };
  const std::vector<Vec3> points = points_about();
  EXPECT_LT(max_distance(follow(bonds_to(points, mesh), translate(mesh.positions, turn), mesh.triangles),
                         translate(points, turn)),
            1e-9);
}

sim::Mesh both(sim::Mesh a, const sim::Mesh& b) {
  const auto first = static_cast<sim::Index>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const sim::Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

TEST(Following, OfTwoWallsTheOneThatFacesAlikeIsFollowed) {
  sim::Mesh walls = sheet(4, 0.001);
  const sim::Mesh lower = sheet(4, 0.0);
  for (const sim::Triangle& t : lower.triangles) {
    const auto first = static_cast<sim::Index>(25);
    walls.triangles.push_back({t[0] + first, t[2] + first, t[1] + first});
  }
  walls.positions.insert(walls.positions.end(), lower.positions.begin(), lower.positions.end());
  const std::vector<Vec3> points = {{0.3, 0.0004, 0.3}, {0.3, 0.0006, 0.3}};
  const std::vector<Vec3> normals = {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}};
  const std::vector<Bond> bonds = bonds_to(points, walls, normals);
  EXPECT_LT(bonds[0].triangle, lower.triangles.size());
  EXPECT_GE(bonds[1].triangle, lower.triangles.size());
  const std::vector<Bond> nearest = bonds_to(points, walls);
  EXPECT_GE(nearest[0].triangle, lower.triangles.size());
  EXPECT_LT(nearest[1].triangle, lower.triangles.size());
}

// A wall 8 mm above a mesh that is bent into waves as narrow as its triangles. Triangles' own normals fan out there.
TEST(Following, ThickModelsKeepTheirThicknessInNarrowFolds) {
  const sim::Mesh mesh = sheet(24);
  const std::vector<std::uint8_t> is_wall(mesh.triangles.size(), 1);
  sim::Mesh model = mesh;
  for (Vec3& p : model.positions) p.y += 0.008;
  std::vector<Vec3> folded_m = mesh.positions;
  for (Vec3& p : folded_m) p.y += 0.004 * std::cos(24.0 * std::numbers::pi * p.x);
  const std::vector<Vec3> points_m =
      follow(bonds_of_model(model, is_wall, mesh), folded_m, mesh.triangles, fitting::normal_smoothing_rounds);
  for (std::size_t v = 0; v < points_m.size(); ++v) {
    EXPECT_LT(glm::distance(points_m[v], folded_m[v] + Vec3(0.0, 0.008, 0.0)), 0.001);
  }
}

/// Binds two layers to meshes of two layers. Returns how many vertices of the upper layer follow the lower one.
std::size_t count_at_lower(const sim::Mesh& upper, const sim::Mesh& lower, const sim::Mesh& upper_mesh,
                           const sim::Mesh& lower_mesh) {
  const sim::Mesh model = both(upper, lower), mesh = both(upper_mesh, lower_mesh);
  const std::vector<Bond> bonds = bonds_of_model(model, std::vector<std::uint8_t>(model.triangles.size(), 1), mesh);
  return static_cast<std::size_t>(
      std::count_if(bonds.begin(), bonds.begin() + static_cast<std::ptrdiff_t>(upper.positions.size()),
                    [&](const Bond& bond) { return bond.triangle >= upper_mesh.triangles.size(); }));
}

// In the middle the mesh of the lower layer is nearer to the upper layer than its own mesh.
TEST(Following, ALayerFollowsItsOwnMeshWhereAnotherIsNearer) {
  const sim::Mesh upper = sheet(24, 0.002), lower = sheet(24);
  sim::Mesh upper_mesh = upper;
  for (Vec3& p : upper_mesh.positions) p.y += 0.01 * std::sin(3.14 * p.x) * std::sin(3.14 * p.z);
  EXPECT_EQ(count_at_lower(upper, lower, upper_mesh, lower), 0U);
}

// The upper layer is crumpled at a place near to the lower one, which faces down. There alone the lower one seems to be
// its own.
TEST(Following, ACrumpledPlaceDoesNotDecideWhichLayerIsFollowed) {
  const sim::Mesh upper_mesh = sheet(24, 0.004);
  sim::Mesh lower = sheet(24), upper = upper_mesh;
  for (sim::Triangle& t : lower.triangles) std::swap(t[1], t[2]);
  const auto at = [](int x, int z) { return z * 25 + x; };
  lower.positions[at(12, 12)].y = 0.003;
  for (int x = 10; x <= 14; ++x) {
    for (int z = 10; z <= 14; ++z) upper.positions[at(x, z)] = Vec3((24.0 - x) / 24.0, 0.0032, z / 24.0);
  }
  EXPECT_EQ(count_at_lower(upper, lower, upper_mesh, lower), 0U);
}

TEST(Following, TheNearestCornerIsThatOfTheLargestWeight) {
  const sim::Mesh mesh = sheet(2);
  const std::vector<Bond> bonds = bonds_to(std::vector<Vec3>{{0.48, 0.01, 0.03}}, mesh);
  EXPECT_EQ(find_nearest_corner(bonds[0], mesh.triangles), 1U);
}

}  // namespace
}  // namespace taut::app
