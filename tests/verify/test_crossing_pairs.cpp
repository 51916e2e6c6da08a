#include <gtest/gtest.h>

#include <random>

#include "app/verify/crossing_pairs.hpp"
#include "separating_axes.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

/// Triangles between random vertices. Many vertices are shared.
struct Soup {
  std::vector<test::Whole> places;
  std::vector<Vec3> positions_m;
  std::vector<sim::Triangle> triangles;

  Soup(std::mt19937& random, int size, sim::Index vertices, std::size_t count) {
    std::uniform_int_distribution<int> coordinate(-size, size);
    for (sim::Index v = 0; v < vertices; ++v) {
      const test::Whole p = {coordinate(random), 3 * coordinate(random), coordinate(random)};
      places.push_back(p);
      positions_m.emplace_back(0.125 * Vec3(p[0], p[1], p[2]));
    }
    std::uniform_int_distribution<sim::Index> vertex(0, vertices - 1);
    while (triangles.size() < count) {
      const sim::Triangle t = {vertex(random), vertex(random), vertex(random)};
      if (test::has_area(corners(t))) {
        triangles.push_back(t);
      }
    }
  }

  sim::Surface surface() const { return {positions_m, triangles}; }

  test::WholeCorners corners(const sim::Triangle& t) const { return {places[t[0]], places[t[1]], places[t[2]]}; }

  /// Puts the shared vertices first and compares in whole numbers.
  bool do_cross(sim::Triangle a, sim::Triangle b) const {
    const auto is_in = [](const sim::Triangle& t) {
      return [&t](sim::Index v) { return std::find(t.begin(), t.end(), v) != t.end(); };
    };
    const sim::Triangle first = a;
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    const auto end = std::stable_partition(a.begin(), a.end(), is_in(b));
    std::stable_partition(b.begin(), b.end(), is_in(first));
    return test::do_cross(corners(a), corners(b), static_cast<std::size_t>(end - a.begin()));
  }
};

using Indices = std::vector<std::array<sim::Index, 2>>;

Indices to_indices(const std::vector<sim::CrossingPair>& pairs) {
  Indices indices;
  for (const sim::CrossingPair& pair : pairs) {
    indices.push_back({pair.first, pair.second});
  }
  return indices;
}

TEST(CrossingPairs, AreThoseOfAllPairsOfTriangles) {
  std::mt19937 random(3);  // NOLINT: the same triangles in every run
  for (const int size : {2, 5, 20}) {
    const Soup soup(random, size, 60, 120);
    Indices expected;
    for (sim::Index i = 0; i < soup.triangles.size(); ++i) {
      for (sim::Index j = i + 1; j < soup.triangles.size(); ++j) {
        if (soup.do_cross(soup.triangles[i], soup.triangles[j])) {
          expected.push_back({i, j});
        }
      }
    }
    EXPECT_EQ(to_indices(crossing_pairs(soup.surface())), expected) << size;
    EXPECT_GT(expected.size(), 50U) << size;
    EXPECT_LT(expected.size(), 7000U) << size;
  }
}

TEST(CrossingPairs, OfClothAndBodyAreThoseOfAllPairsOfTheirTriangles) {
  std::mt19937 random(4);  // NOLINT: the same triangles in every run
  const Soup cloth(random, 6, 30, 70), body(random, 6, 30, 50);
  Indices expected;
  for (sim::Index i = 0; i < cloth.triangles.size(); ++i) {
    for (sim::Index j = 0; j < body.triangles.size(); ++j) {
      if (test::do_cross(cloth.corners(cloth.triangles[i]), body.corners(body.triangles[j]), 0)) {
        expected.push_back({i, j});
      }
    }
  }
  EXPECT_EQ(to_indices(crossing_pairs(cloth.surface(), body.surface())), expected);
  EXPECT_GT(expected.size(), 50U);
}

TEST(CrossingPairs, CountTrianglesThatAreFoldedFlat) {
  const std::vector<Vec3> positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 9}, {1, 1, 0.5}};
  const std::vector<sim::Triangle> triangles = {{0, 1, 2}, {3, 4, 5}, {3, 6, 5}};
  const sim::Surface cloth = {positions, triangles};
  const std::vector<sim::CrossingPair> pairs = crossing_pairs(cloth);
  // The last two triangles share two vertices and overlap, folded flat.
  EXPECT_EQ(to_indices(pairs), (Indices{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(CrossingPairs, AreNoneInASheetAndItsNeighbourhoods) {
  std::vector<Vec3> positions;
  std::vector<sim::Triangle> triangles;
  for (sim::Index r = 0; r < 30; ++r) {
    for (sim::Index c = 0; c < 30; ++c) {
      positions.emplace_back(0.01 * c, 0.01 * r, 0.003 * ((r + c) % 2));
      if (r > 0 && c > 0) {
        const sim::Index here = 30 * r + c;
        triangles.push_back({here - 31, here - 30, here});
        triangles.push_back({here - 31, here, here - 1});
      }
    }
  }
  EXPECT_TRUE(crossing_pairs({positions, triangles}).empty());
  positions[30 * 15 + 15] = positions[30 * 15 + 17] + Vec3(0.002, 0.0, 0.0);
  EXPECT_FALSE(crossing_pairs({positions, triangles}).empty()) << "a vertex pulled across two others";
}

TEST(CrossingPairs, RefusesPlacesThatHaveNoRationalNumbers) {
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    const std::vector<Vec3> positions_m = {{0, 0, 0},      {1, 0, 0},     {0, 1, 0},
                                           {0.2, 0.2, -1}, {0.3, 0.2, 1}, {wrong, 1, 0}};
    const std::vector<sim::Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
    const sim::Surface surface{positions_m, triangles};
    EXPECT_THROW(crossing_pairs(surface), std::invalid_argument) << wrong;
    EXPECT_THROW(
        crossing_pairs({positions_m, std::span(triangles).first(1)}, {positions_m, std::span(triangles).last(1)}),
        std::invalid_argument)
        << wrong;
  }
}

}  // namespace
}  // namespace taut::app
