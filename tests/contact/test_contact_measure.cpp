#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "app/verify/crossing_pairs.hpp"
#include "sim/contact/contact_measure.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/contact/triangle_pair.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::sim {
namespace {

struct Shape3 {
  std::vector<Vec3> positions_m;
  std::vector<Triangle> triangles;

  Surface surface() const { return {positions_m, triangles}; }
  MeasuredContact measured(double reach_m, std::vector<Body> bodies = {}) const {
    return ContactMeasure(triangles, positions_m, std::move(bodies)).measure(positions_m, 0.0, reach_m);
  }
};

Vec3 random_in(double size_m, std::mt19937& random) {
  std::uniform_real_distribution<double> of(-size_m, size_m);
  return {of(random), of(random), of(random)};
}

double distance_m(const Vec3& place_m, const Surface& surface, Index triangle) {
  const Triangle& t = surface.triangles[triangle];
  return point_triangle_distance_m(place_m,
                                   {surface.positions_m[t[0]], surface.positions_m[t[1]], surface.positions_m[t[2]]});
}

/// Requires the pairs that the exact test finds, each with a place that is in both triangles.
void expect_pairs(const std::vector<CrossingPair>& found, const std::vector<CrossingPair>& expected,
                  const Surface& cloth, const Surface& other) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].first, expected[k].first) << k;
    EXPECT_EQ(found[k].second, expected[k].second) << k;
    EXPECT_LT(distance_m(found[k].place_m, cloth, found[k].first), 1e-9) << k;
    EXPECT_LT(distance_m(found[k].place_m, other, found[k].second), 1e-9) << k;
  }
}

/// A sheet that is crumpled at random, so that neighbouring and distant triangles cross each other.
Shape3 crumpled_sheet(double by_m, unsigned seed) {
  std::mt19937 random(seed);
  Mesh mesh = make_grid({.columns = 15, .rows = 15});
  for (Vec3& p : mesh.positions) {
    p = Vec3(p.x, 0.3 * p.y, 0.2 * std::sin(9.0 * p.y)) + random_in(by_m, random);
  }
  return {mesh.positions, mesh.triangles};
}

/// Triangles without common vertices.
Shape3 soup(std::size_t triangles, double size_m, unsigned seed) {
  std::mt19937 random(seed);
  Shape3 shape;
  for (Index t = 0; t < triangles; ++t) {
    const Vec3 at = random_in(0.3, random);
    for (int k = 0; k < 3; ++k) {
      shape.positions_m.push_back(at + random_in(size_m, random));
    }
    shape.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return shape;
}

TEST(ContactMeasure, CountsWhatExactPredicatesCount) {
  std::size_t all = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    for (const double by_m : {0.0, 0.01, 0.03, 0.1}) {
      const Shape3 sheet = crumpled_sheet(by_m, seed);
      const std::vector<CrossingPair> expected = app::crossing_pairs(sheet.surface());
      EXPECT_EQ(sheet.measured(0.001).crossing_pairs, expected.size()) << seed << ' ' << by_m;
      expect_pairs(find_crossing_pairs(sheet.surface()), expected, sheet.surface(), sheet.surface());
      all += expected.size();
    }
    const Shape3 triangles = soup(300, 0.06, seed);
    const std::size_t expected = app::crossing_pairs(triangles.surface()).size();
    EXPECT_EQ(triangles.measured(0.001).crossing_pairs, expected) << seed;
    EXPECT_EQ(triangles.measured(0.001).min_distance_m == 0.0, expected > 0) << seed;
  }
  EXPECT_GT(all, 1000U);
}

TEST(ContactMeasure, FindsCrossingsOfMarkedTrianglesAlone) {
  const Shape3 sheet = crumpled_sheet(0.03, 3);
  const std::size_t count = sheet.triangles.size();
  for (const std::size_t stride : {1, 7, 400, 100000}) {
    std::vector<std::uint8_t> is_marked(count, 0);
    for (std::size_t t = stride / 2; t < count; t += stride) is_marked[t] = 1;
    std::vector<CrossingPair> expected = app::crossing_pairs(sheet.surface());
    std::erase_if(expected, [&](const auto& p) { return is_marked[p.first] == 0 && is_marked[p.second] == 0; });
    const TriangleTree tree(sheet.triangles, sheet.positions_m);
    expect_pairs(find_crossing_pairs(sheet.surface(), tree, is_marked), expected, sheet.surface(), sheet.surface());
  }
}

// A fan that goes around its vertex twice faces the same way everywhere and still crosses itself.
TEST(ContactMeasure, CountsAFanThatGoesAroundTwice) {
  Shape3 fan = {{Vec3(0.0)}, {}};
  constexpr Index spokes = 13;
  for (Index k = 0; k < spokes; ++k) {
    const double angle = 4.0 * std::numbers::pi * k / spokes;
    fan.positions_m.push_back({std::cos(angle), 0.2 * std::sin(0.5 * angle + 0.3), std::sin(angle)});
    fan.triangles.push_back({0, 1 + (k + 1) % spokes, 1 + k});
  }
  const std::size_t expected = app::crossing_pairs(fan.surface()).size();
  EXPECT_GT(expected, 0U);
  EXPECT_EQ(fan.measured(0.001).crossing_pairs, expected);
}

/// Returns the smallest distance of points all over triangle a from triangle b.
double sampled_distance_m(const Corners& a, const Corners& b) {
  double least = INFINITY;
  constexpr int cuts = 40;
  for (int i = 0; i <= cuts; ++i) {
    for (int j = 0; i + j <= cuts; ++j) {
      const Vec3 p = a[0] + (a[1] - a[0]) * (double(i) / cuts) + (a[2] - a[0]) * (double(j) / cuts);
      least = std::min(least, point_triangle_distance_m(p, b));
    }
  }
  return least;
}

// The quick answer about neighbours is never another than that of their measure, and is given to most.
TEST(ContactMeasure, NeighboursThatLieApartAreMeasuredApart) {
  std::mt19937 random(11);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3> positions_m;
    for (int k = 0; k < 5; ++k) positions_m.push_back(random_in(0.01, random));
    const double distance_m = std::pow(10.0, -6.0 + i % 4);
    if (!corner_neighbours_lie_apart({0, 1, 2}, {3, 0, 4}, positions_m, distance_m)) continue;
    ++apart;
    const TrianglePairMeasure measured = measure_neighbours({0, 1, 2}, {3, 0, 4}, positions_m);
    EXPECT_FALSE(measured.is_pierced);
    EXPECT_GE(measured.parts_m, distance_m);
    EXPECT_FALSE(neighbours_cross({0, 1, 2}, {3, 0, 4}, positions_m));
  }
  EXPECT_GT(apart, 400);
  const std::vector<Vec3> square_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_FALSE(corner_neighbours_lie_apart({0, 1, 2}, {0, 2, 3}, square_m, 1e-6)) << "they share an edge";
}

TEST(ContactMeasure, FindsTheNearestPair) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Shape3 triangles = soup(12, 0.05, 100 + seed);
    double expected = INFINITY;
    for (Index s = 0; s < 12; ++s) {
      for (Index t = s + 1; t < 12; ++t) {
        const auto corners = [&](Index n) {
          return Corners{triangles.positions_m[3 * n], triangles.positions_m[3 * n + 1],
                         triangles.positions_m[3 * n + 2]};
        };
        expected = std::min(
            {expected, sampled_distance_m(corners(s), corners(t)), sampled_distance_m(corners(t), corners(s))});
      }
    }
    const double found = triangles.measured(1.0).min_distance_m;
    if (app::crossing_pairs(triangles.surface()).empty()) {
      EXPECT_LE(found, expected + 1e-12) << seed;
      EXPECT_GT(found, expected - 2e-3) << seed;
      EXPECT_EQ(triangles.measured(0.99 * found).min_distance_m, INFINITY) << seed;
      EXPECT_EQ(triangles.measured(1.01 * found).min_distance_m, found) << seed;
    }
  }
}

TEST(ContactMeasure, MeasuresBodies) {
  const Shape3 sheet = crumpled_sheet(0.03, 3);
  const Vec3 far_m = {0.0, 0.0, 2.0};
  const Shape3 lower = soup(200, 0.1, 5);
  const Body mesh = {
      .shape = BodyMesh{std::make_shared<const BodyMeshData>(BodyMeshData{lower.positions_m, lower.triangles})}};
  const Shape3 alone = {sheet.positions_m, sheet.triangles};
  const std::size_t own = alone.measured(0.001).crossing_pairs;
  expect_pairs(find_crossing_pairs(sheet.surface(), lower.surface()),
               app::crossing_pairs(sheet.surface(), lower.surface()), sheet.surface(), lower.surface());
  EXPECT_EQ(alone.measured(0.001, {mesh}).crossing_pairs - own,
            app::crossing_pairs(sheet.surface(), lower.surface()).size());

  const Capsule limb = {{-0.3, -0.1, 0.0}, {0.3, 0.1, 0.05}, 0.05, 0.12};
  std::size_t entering = 0;
  for (const auto& [i, j, k] : sheet.triangles) {
    const app::Corners corners = {sheet.positions_m[i], sheet.positions_m[j], sheet.positions_m[k]};
    entering += app::enters_limb(corners, {limb.start_m, limb.end_m, limb.start_radius_m, limb.end_radius_m}) ? 1 : 0;
  }
  EXPECT_GT(entering, 10U);
  EXPECT_EQ(alone.measured(0.001, {{.shape = limb}}).crossing_pairs - own, entering);
  EXPECT_EQ(alone.measured(0.001, {{.shape = Sphere{far_m, 0.1}}}).crossing_pairs, own);

  const Shape3 triangle = {{{0.0, 0.5, 0.0}, {1.0, 0.5, 0.0}, {0.0, 0.5, 1.0}}, {{0, 1, 2}}};
  EXPECT_NEAR(triangle.measured(1.0, {{.shape = Sphere{{0.2, 0.8, 0.2}, 0.1}}}).min_distance_m, 0.2, 1e-12);
  EXPECT_NEAR(triangle.measured(1.0, {{.shape = Plane{{0.0, 0.6, 0.0}, {0.0, 1.0, 0.0}}}}).min_distance_m, -0.1, 1e-12);
  EXPECT_NEAR(triangle.measured(1.0, {{.shape = Capsule{{0.2, 0.9, 0.2}, {0.2, 1.4, 0.2}, 0.1, 0.3}}}).min_distance_m,
              0.3, 1e-9);
}

}  // namespace
}  // namespace taut::sim
