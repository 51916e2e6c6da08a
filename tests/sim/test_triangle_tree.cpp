#include <gtest/gtest.h>

#include "sim/contact/triangle_pair.hpp"
#include "sim/contact/triangle_tree.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {
namespace {

// A missing triangle in the last leaf has no box, so that not even an infinite one overlaps it.
TEST(TriangleTree, FindsNoMissingTriangleNearInfiniteOnes) {
  std::vector<Vec3> positions_m;
  std::vector<Triangle> triangles;
  for (Index t = 0; t < 11; ++t) {
    for (const Vec3& corner : {Vec3(-1e39), Vec3(1e39), Vec3(t, 1e39, 0.0)}) positions_m.push_back(corner);
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  TriangleTree tree(triangles, positions_m);
  tree.fit(positions_m, Vec3(0.0), 1e-3);
  std::vector<TriangleCouple> pairs;
  tree.find_near(pairs);
  tree.find_near(tree, pairs);
  for (const auto& [s, t] : pairs) {
    EXPECT_LT(s, triangles.size());
    EXPECT_LT(t, triangles.size());
  }
}

bool share_vertex(const Triangle& s, const Triangle& t) {
  return std::any_of(s.begin(), s.end(), [&](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); });
}

// A sheet rolled up so that its windings lie 2 mm apart, and a fan of so many triangles that neighbours are not listed.
TEST(TriangleTree, FindsEveryNearPairOnceButNoNeighbours) {
  constexpr Index side = 24;
  constexpr double reach_m = 3e-3;
  std::vector<Vec3> positions_m;
  std::vector<Triangle> triangles;
  for (Index i = 0; i < side; ++i) {
    for (Index j = 0; j < side; ++j) {
      const double radius_m = 0.02 + 2e-3 * i / 8.0, angle = 2.0 * std::numbers::pi * i / 8.0;
      positions_m.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.01 * j);
      if (i + 1 < side && j + 1 < side) {
        const Index v = i * side + j;
        triangles.push_back({v, v + side, v + 1});
        triangles.push_back({v + 1, v + side, v + side + 1});
      }
    }
  }
  const auto hub = static_cast<Index>(positions_m.size());
  positions_m.emplace_back(0.5, 0.0, 0.0);
  for (int k = 0; k < 40; ++k) {
    positions_m.emplace_back(0.5 + 0.02 * std::cos(0.15 * k), 0.02 * std::sin(0.15 * k), 1e-3 * (k % 2));
    if (k > 0) triangles.push_back({hub, static_cast<Index>(hub + k), static_cast<Index>(hub + k + 1)});
  }
  TriangleTree tree(triangles, positions_m);
  tree.fit(positions_m, Vec3(0.0), reach_m);
  std::vector<TriangleCouple> found;
  tree.find_near(found);
  for (TriangleCouple& pair : found) {
    EXPECT_FALSE(share_vertex(triangles[pair[0]], triangles[pair[1]]));
    std::sort(pair.begin(), pair.end());
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
  std::size_t near_count = 0;
  for (Index s = 0; s < triangles.size(); ++s) {
    for (Index t = s + 1; t < triangles.size(); ++t) {
      if (share_vertex(triangles[s], triangles[t])) continue;
      const TrianglePairMeasure pair = measure_pair(triangles[s], triangles[t], positions_m, positions_m, reach_m);
      if (!(pair.distance_m() <= reach_m)) continue;
      ++near_count;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), TriangleCouple{s, t})) << s << " and " << t;
    }
  }
  EXPECT_GT(near_count, triangles.size());
}

}  // namespace
}  // namespace taut::sim
