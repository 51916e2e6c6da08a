// Points that follow a mesh to which they are bound.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/garments/fitting/following.hpp"
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

TEST(Following, WhatIsCarriedStaysBelowTheWallAsItIsDrawn) {
  const sim::Mesh mesh = sheet(24);
  sim::Mesh model = sheet(4);
  std::vector<std::uint8_t> is_wall(model.triangles.size(), 1);
  const auto first = static_cast<sim::Index>(model.positions.size());
  const std::array<Vec3, 3> carried_at = {Vec3(0.36, -0.001, 0.4), Vec3(0.6, -0.001, 0.35), Vec3(0.65, -0.001, 0.6)};
  model.positions.insert(model.positions.end(), carried_at.begin(), carried_at.end());
  model.triangles.push_back({first, first + 1, first + 2});
  is_wall.push_back(0);
  const CarriedVertices carried = carried_vertices(model, is_wall);
  ASSERT_EQ(carried.vertices.size(), carried_at.size());
  const std::vector<float> shares(model.positions.size(), 1.0F);
  std::vector<Vec3> points_m =
      follow(bonds_of_model(model, is_wall, mesh), translate(mesh.positions, wave), mesh.triangles, shares);
  carry(carried, shares, points_m);
  const sim::Mesh wall{points_m, carried.wall, {}};
  for (sim::Index v = first; v < points_m.size(); ++v) {
    const Bond below = bonds_to(std::span(&points_m[v], 1), wall)[0];
    EXPECT_NEAR(below.offset_m.z, -0.001, 1e-4);
    EXPECT_NEAR(glm::length(below.offset_m), 0.001, 1e-4);
  }
}

TEST(Following, TheNearestCornerIsThatOfTheLargestWeight) {
  const sim::Mesh mesh = sheet(2);
  const std::vector<Bond> bonds = bonds_to(std::vector<Vec3>{{0.48, 0.01, 0.03}}, mesh);
  EXPECT_EQ(find_nearest_corner(bonds[0], mesh.triangles), 1U);
}

}  // namespace
}  // namespace taut::app
