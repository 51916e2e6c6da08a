#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "renderer/frame_view.hpp"

namespace taut::renderer {
namespace {

TEST(VertexNormals, FlatSheetPointsToItsCounterClockwiseSide) {
  constexpr std::array<glm::vec3, 4> positions{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  constexpr std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  std::array<glm::vec3, 4> normals{};
  vertex_normals(positions, triangles, normals);
  for (const glm::vec3& normal : normals) EXPECT_EQ(normal, (glm::vec3{0, 0, 1}));
}

// A corner of a cube whose front face is cut in two: weights by angle count each face alike, unlike weights by area.
TEST(VertexNormals, AngleWeightDoesNotDependOnHowAFaceIsCut) {
  constexpr std::array<glm::vec3, 7> positions{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  // Three squares meet at vertex 0; the one in the xy plane is cut through vertex 0.
  constexpr std::array<std::uint32_t, 12> triangles{0, 2, 1, 0, 3, 2, 0, 1, 4, 0, 4, 3};
  std::array<glm::vec3, 7> normals{};
  vertex_normals(positions, triangles, normals);
  const glm::vec3 expected = glm::normalize(glm::vec3{-1, -1, -1});
  EXPECT_NEAR(glm::distance(normals[0], expected), 0.0F, 1e-6F);
}

TEST(VertexNormals, DegenerateTrianglesAndLooseVerticesDoNoHarm) {
  constexpr std::array<glm::vec3, 5> positions{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}}};
  constexpr std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 1, 3};
  std::array<glm::vec3, 5> normals{};
  vertex_normals(positions, triangles, normals);
  EXPECT_EQ(normals[0], (glm::vec3{0, 0, 1}));
  EXPECT_EQ(normals[3], (glm::vec3{0, 1, 0}));
  EXPECT_EQ(normals[4], (glm::vec3{0, 1, 0}));
}

TEST(Primitives, AreOrientedOutwardsAndHaveTheirRadius) {
  for (const TriangleMesh& mesh : {make_sphere({1, 2, 3}, 0.5F), make_capsule({1, 2, 3}, {1, 2, 4}, 0.5F),
                                   make_capsule({0, 0, 0}, {2, 1, 0}, 0.5F)}) {
    std::vector<glm::vec3> normals(mesh.positions.size());
    vertex_normals(mesh.positions, mesh.triangles, normals);
    // The rings at the poles are points whose normals come from slivers.
    for (std::size_t i = 48; i + 48 < normals.size(); ++i) {
      EXPECT_GT(glm::dot(normals[i], mesh.normals[i]), 0.97F) << i;
    }
  }
  const TriangleMesh ball = make_sphere({1, 2, 3}, 0.5F);
  for (const glm::vec3& position : ball.positions) {
    EXPECT_NEAR(glm::distance(position, glm::vec3(1, 2, 3)), 0.5F, 1e-5F);
  }
}

}  // namespace
}  // namespace taut::renderer
