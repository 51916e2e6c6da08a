#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat3x3.hpp>

#include "app/verify/stretch.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

LargestStretch stretch_by(const sim::Mesh& rest, const glm::dmat3& map) {
  std::vector<Vec3> positions_m;
  for (const Vec3& p : rest.positions) {
    positions_m.push_back(map * p);
  }
  return largest_stretch(rest, positions_m);
}

TEST(VerifiedStretch, IsTheLargestSingularValue) {
  const sim::Mesh sheet = sim::make_grid({.columns = 4, .rows = 4});
  const LargestStretch along = stretch_by(sheet, {{1.25, 0, 0}, {0, 0.5, 0}, {0, 0, 1}});
  EXPECT_NEAR(along.springs, 0.25, 1e-12);
  EXPECT_NEAR(along.surface, 0.25, 1e-12);
  // A shear by s has the singular values sqrt(1 + s^2 / 4) +- s / 2. A rotation keeps lengths.
  const double s = 0.5, turn = 0.6, other = 0.8;
  const glm::dmat3 sheared = {{1, 0, 0}, {s, 1, 0}, {0, 0, 1}};
  const glm::dmat3 turned = {{turn, 0, other}, {0, 1, 0}, {-other, 0, turn}};
  const LargestStretch across = stretch_by(sheet, turned * sheared);
  EXPECT_NEAR(across.surface, std::sqrt(1.0 + 0.25 * s * s) + 0.5 * s - 1.0, 1e-12);
  EXPECT_LT(across.springs, across.surface);
}

// A shear to either side lengthens one diagonal of a square: an edge of its triangles, or the other diagonal.
TEST(VerifiedStretch, IsThatOfBothDiagonals) {
  const sim::Mesh sheet = sim::make_grid({.columns = 2, .rows = 2, .width_m = 1.0, .height_m = 1.0});
  for (const double s : {0.5, -0.5}) {
    const LargestStretch sheared = stretch_by(sheet, {{1, 0, 0}, {s, 1, 0}, {0, 0, 1}});
    EXPECT_NEAR(sheared.springs, std::hypot(1.5, 1.0) / std::sqrt(2.0) - 1.0, 1e-12);
  }
}

TEST(VerifiedStretch, OfANeedleIsThatOfItsEdges) {
  const sim::Mesh needle = {
      .positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 5e-4, 0}}, .triangles = {{0, 1, 2}}, .quads = {}};
  const LargestStretch widened = stretch_by(needle, {{1.1, 0, 0}, {0, 9, 0}, {0, 0, 1}});
  EXPECT_NEAR(widened.springs, 0.1, 1e-4);
  EXPECT_EQ(widened.surface, -1.0);
}

}  // namespace
}  // namespace taut::app
