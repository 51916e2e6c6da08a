#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/mesh/mesh.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::sim {
namespace {

struct Face {
  std::vector<Vec3> corners;

  std::vector<Triangle> cut() const {
    std::vector<Index> order(corners.size());
    for (Index k = 0; k < order.size(); ++k) {
      order[k] = k;
    }
    const std::vector<std::uint32_t> counts = {static_cast<std::uint32_t>(corners.size())};
    return cut_into_triangles({corners, counts, order});
  }
  Vec3 area() const {
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      sum += Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }
    return sum;
  }
};

/// The triangles cover the face once, on its own side, and none is empty.
void expect_cover(const Face& face) {
  const std::vector<Triangle> triangles = face.cut();
  ASSERT_EQ(triangles.size(), face.corners.size() - 2);
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const Vec3 area = doubled_area_vector(face.corners, t);
    EXPECT_GT(area.x * face.area().x + area.y * face.area().y + area.z * face.area().z, 0.0);
    sum += std::sqrt(area.x * area.x + area.y * area.y + area.z * area.z);
  }
  const Vec3 a = face.area();
  EXPECT_NEAR(sum, std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z), 1e-9 * sum);
}

TEST(Polygons, CutsAQuadAlongItsFirstDiagonalUnlessThatIsBad) {
  EXPECT_EQ((Face{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}.cut()),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  // Concave at corner 3: the diagonal 0-2 lies outside.
  EXPECT_EQ((Face{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}}}.cut()),
            (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Polygons, CutsConcaveFacesInsideTheirOutline) {
  expect_cover({{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}});  // an L
  expect_cover({{{0, 0, 0}, {0, 3, 0}, {1, 3, 0}, {1, 1, 0}, {3, 1, 0}, {3, 0, 0}}});  // from behind
  expect_cover(
      {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}});  // a U
  expect_cover(
      {{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}, {0.5, 1, 0}, {0, 1, 0}, {0, 0.5, 0}}});
}

TEST(Polygons, CutsStarsAndSpirals) {
  Face star;
  for (int k = 0; k < 40; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 40, radius = k % 2 == 0 ? 1.0 : 0.2;
    star.corners.push_back({radius * std::cos(angle), 0.3, radius * std::sin(angle)});
  }
  expect_cover(star);
  Face spiral;
  for (int k = 0; k < 60; ++k) {
    spiral.corners.push_back({(1.0 + 0.1 * k) * std::cos(0.3 * k), (1.0 + 0.1 * k) * std::sin(0.3 * k), 0.0});
  }
  for (int k = 59; k >= 0; --k) {
    spiral.corners.push_back({(0.9 + 0.1 * k) * std::cos(0.3 * k), (0.9 + 0.1 * k) * std::sin(0.3 * k), 0.0});
  }
  expect_cover(spiral);
}

TEST(Polygons, EndsOnBadOutlinesToo) {
  EXPECT_EQ((Face{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}}}.cut().size()),
            3u);  // crosses itself
  EXPECT_EQ((Face{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}}.cut().size()), 3u);  // a line
  EXPECT_EQ((Face{std::vector<Vec3>(7, Vec3(1e300))}.cut().size()), 5u);
}

std::string error_text(std::vector<std::uint32_t> counts, std::vector<Index> corners) {
  const std::vector<Vec3> positions(4, Vec3(0.0));
  try {
    cut_into_triangles({positions, counts, corners});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Polygons, RefusesBadFacesWithTheReason) {
  EXPECT_EQ(error_text({2}, {0, 1}), "face 0 has 2 corners; expected 3 to 5000");
  EXPECT_EQ(error_text({3, 4}, {0, 1, 2, 3, 1}), "face 1 has 4 corners, but only 2 are there");
  EXPECT_EQ(error_text({3}, {0, 1, 4}), "face 0 uses vertex 4, but there are only 4");
  EXPECT_EQ(error_text({3}, {0, 1, 2, 3}), "1 corners belong to no face");
}

}  // namespace
}  // namespace taut::sim
