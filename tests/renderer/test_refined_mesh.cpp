#include <gtest/gtest.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <map>

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {
namespace {

// A square of two triangles, and a third triangle on its right.
const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3, 1, 4, 2};

const std::vector<glm::vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::uint32_t> tetrahedron_faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

TEST(RefinedMesh, SplitsEachTriangleIntoFourAtSharedMidpoints) {
  const RefinedMesh mesh(positions, triangles, 2);
  EXPECT_EQ(mesh.triangles().size(), 3U * 3U * 16U);
  EXPECT_EQ(mesh.coarse_vertex_count() + mesh.parents().size(), mesh.vertex_count());
  std::vector<glm::vec3> places = positions;
  interpolate(std::span(mesh.parents()), places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(std::count(places.begin(), places.end(), places[i]), 1) << "one vertex for each midpoint";
  }
  for (std::size_t i = 0; i < mesh.triangles().size(); i += 3) {
    const glm::vec3 a = places[mesh.triangles()[i]];
    const glm::vec3 b = places[mesh.triangles()[i + 1]];
    const glm::vec3 c = places[mesh.triangles()[i + 2]];
    EXPECT_NEAR((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 1.0F / 16.0F, 1e-6F) << "turned over";
  }
}

TEST(RefinedMesh, ClosedStaysClosed) {
  EXPECT_TRUE(RefinedMesh(tetrahedron, tetrahedron_faces, 3).border().empty());
  EXPECT_EQ(RefinedMesh(positions, triangles, 2).border().size(), 4U * 5U);
}

TEST(RefinedMesh, BordersGoOnUntilTheirEnds) {
  const RefinedMesh mesh(positions, triangles, 1);
  const std::vector<LinkedBorderEdge>& border = mesh.border();
  std::uint32_t edge = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    EXPECT_EQ(border[edge].ends[1], border[border[edge].next].ends[0]);
    EXPECT_EQ(border[border[edge].next].previous, edge);
    EXPECT_EQ(mesh.triangles()[border[edge].side], border[edge].ends[0]);
    edge = border[edge].next;
  }
  EXPECT_EQ(edge, 0U) << "once around";
  const auto corners =
      std::count_if(border.begin(), border.end(), [](const LinkedBorderEdge& e) { return e.corners[0]; });
  EXPECT_EQ(corners, 3)
      << "two of the square, one of the triangle; where it joins the border turns by 45 degrees or less";
}

TEST(RefinedMesh, CornerValuesKeepWhatDiffersAcrossAnEdge) {
  const std::vector<glm::vec2> corners{{0, 0}, {1, 0}, {1, 1}, {5, 5}, {6, 6}, {5, 6}, {1, 0}, {2, 0}, {1, 1}};
  const std::vector<glm::vec2> fine = refined_corner_values(std::span(corners), 2);
  const RefinedMesh mesh(positions, triangles, 2);
  ASSERT_EQ(fine.size(), mesh.triangles().size());
  std::vector<glm::vec3> places = positions;
  interpolate(std::span(mesh.parents()), places);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const glm::vec2 flat(places[mesh.triangles()[i]]);
    EXPECT_EQ(fine[i], i / 48 == 1 ? flat + 5.0F : flat) << i;
  }
}

TEST(RefinedMesh, EdgesBecomeChainsAlongTheSurface) {
  const RefinedMesh mesh(positions, triangles, 2);
  const std::vector<VertexPair> edges{{1, 0}, {0, 4}};
  const std::vector<VertexPair> fine = mesh.refined_edges(edges);
  ASSERT_EQ(fine.size(), 4U + 1U) << "0 and 4 have no edge";
  EXPECT_EQ(fine.front()[0], 1U);
  EXPECT_EQ(fine[3][1], 0U);
  EXPECT_EQ(fine[4], (VertexPair{0, 4}));
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(fine[i][0], fine[i - 1][1]);
}

TEST(RefinedMesh, IsFineOnlyWhereItShows) {
  EXPECT_EQ(refinement_levels(4.0F, 10'000), 0);
  EXPECT_EQ(refinement_levels(13.0F, 10'000), 1);
  EXPECT_EQ(refinement_levels(30.0F, 10'000), 2);
  EXPECT_EQ(refinement_levels(30.0F, 90'000), 1) << "too many triangles";
  EXPECT_EQ(refinement_levels(1e9F, 2), 4);
}

}  // namespace
}  // namespace taut::renderer
