#include <gtest/gtest.h>

#include "sim/mesh/grid.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::sim {
namespace {

Topology make_topology(const Mesh& mesh) { return measure_topology(mesh, make_adjacency(mesh)); }

const Vec3 o = {0, 0, 0}, x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1}, w = {-1, 0, 0}, n = {0, -1, 0};

TEST(Topology, ASheetHasOneBoundaryLoop) {
  const Topology t = make_topology(make_grid({}));
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.boundary_edges, 32u);
  EXPECT_EQ(t.boundary_loops, 1u);
  EXPECT_EQ(t.non_manifold_edges, 0u);
  EXPECT_EQ(t.non_manifold_vertices, 0u);
  EXPECT_EQ(t.misoriented_edges, 0u);
  EXPECT_EQ(t.euler_characteristic, 1);
}

TEST(Topology, AClosedTetrahedronHasNoBoundary) {
  const Topology t = make_topology({{o, x, y, z}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}});
  EXPECT_EQ(t.boundary_loops, 0u);
  EXPECT_EQ(t.euler_characteristic, 2);
  EXPECT_EQ(t.misoriented_edges, 0u);
}

TEST(Topology, CountsEdgesWhoseTrianglesDisagreeOnTheOutside) {
  EXPECT_EQ(make_topology({{o, x, y, w}, {{0, 1, 2}, {0, 2, 3}}, {}}).misoriented_edges, 0u);
  EXPECT_EQ(make_topology({{o, x, y, w}, {{0, 1, 2}, {0, 3, 2}}, {}}).misoriented_edges, 1u);
}

TEST(Topology, FindsNonManifoldEdgesAndVertices) {
  EXPECT_EQ(make_topology({{o, y, x, w, z}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}}).non_manifold_edges, 1u);
  // Two triangles that touch at one corner.
  const Topology bow_tie = make_topology({{o, x, y, w, n}, {{0, 1, 2}, {0, 3, 4}}, {}});
  EXPECT_EQ(bow_tie.non_manifold_vertices, 1u);
  EXPECT_EQ(bow_tie.components, 1u);
}

TEST(Topology, CountsComponents) {
  const Vec3 far = {5, 5, 5};
  const Topology t = make_topology({{o, x, y, o + far, x + far, y + far}, {{0, 1, 2}, {3, 4, 5}}, {}});
  EXPECT_EQ(t.components, 2u);
  EXPECT_EQ(t.boundary_loops, 2u);
}

}  // namespace
}  // namespace taut::sim
