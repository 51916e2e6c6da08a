#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/garment.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/mesh/subdivide.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::sim {
namespace {

// Two triangles on either side of the diagonal 1-2 of a square, bent along it.
Mesh folded_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}}, {{0, 1, 2}, {1, 3, 2}}, {}};
}

TEST(Subdivide, MakesFourOfEveryTriangleAndSharesTheMidpoints) {
  const PinnedMesh fine = subdivide({folded_square(), {}});
  EXPECT_EQ(fine.mesh.triangles.size(), 8u);
  EXPECT_EQ(fine.mesh.positions.size(), 4u + 5u);
  const Topology t = measure_topology(fine.mesh, make_adjacency(fine.mesh));
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.boundary_edges, 8u);
  EXPECT_EQ(t.boundary_loops, 1u);
  EXPECT_EQ(t.misoriented_edges, 0u);
  EXPECT_EQ(t.euler_characteristic, 1);
}

TEST(Subdivide, KeepsTheSurface) {
  const Mesh coarse = folded_square();
  const Mesh fine = subdivide({coarse, {}}).mesh;
  for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
    const Vec3 whole = doubled_area_vector(coarse.positions, coarse.triangles[t / 4]);
    const Vec3 part = doubled_area_vector(fine.positions, fine.triangles[t]);
    EXPECT_LT(glm::length(4.0 * part - whole), 1e-15) << t;
  }
  for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
    EXPECT_EQ(fine.positions[v], coarse.positions[v]);
  }
}

TEST(Subdivide, PinsTheMidpointsOfPinnedBorderEdgesAlone) {
  // Edges in order: 0-1, 0-2, 1-2, 1-3, 2-3; the diagonal 1-2 is no border.
  EXPECT_EQ(subdivide({folded_square(), {0, 1}}).pins, (std::vector<Index>{0, 1, 4}));
  EXPECT_EQ(subdivide({folded_square(), {1, 2}}).pins, (std::vector<Index>{1, 2}));
  EXPECT_EQ(subdivide({folded_square(), {0, 3}}).pins, (std::vector<Index>{0, 3}));
  EXPECT_EQ(subdivide({folded_square(), {1, 2, 3}}).pins, (std::vector<Index>{1, 2, 3, 7, 8}));
}

TEST(Subdivide, KeepsTheMassAndHalvesTheEdges) {
  const Garment coarse = make_garment(folded_square());
  const Garment fine = make_garment(subdivide({folded_square(), {}}).mesh);
  double coarse_kg = 0.0, fine_kg = 0.0, coarse_m = 0.0, fine_m = 0.0;
  for (const double mass_kg : coarse.masses_kg) {
    coarse_kg += mass_kg;
  }
  for (const double mass_kg : fine.masses_kg) {
    fine_kg += mass_kg;
  }
  EXPECT_NEAR(fine_kg, coarse_kg, 1e-15);
  for (std::size_t s = 0; s < coarse.springs.structural_count; ++s) {
    coarse_m = std::max(coarse_m, coarse.springs.rest_lengths_m[s]);
  }
  for (std::size_t s = 0; s < fine.springs.structural_count; ++s) {
    fine_m = std::max(fine_m, fine.springs.rest_lengths_m[s]);
  }
  EXPECT_NEAR(fine_m, 0.5 * coarse_m, 1e-15);
}

TEST(Subdivide, RefusesGridsAndPinsThatAreNotThere) {
  EXPECT_THROW(subdivide({make_grid({}), {}}), std::invalid_argument);
  EXPECT_THROW(subdivide({folded_square(), {4}}), std::out_of_range);
}

}  // namespace
}  // namespace taut::sim
