#include <gtest/gtest.h>

#include "sim/contact/triangle_tree.hpp"

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

}  // namespace
}  // namespace taut::sim
