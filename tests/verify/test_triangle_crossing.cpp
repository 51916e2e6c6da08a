#include <gtest/gtest.h>

#include <random>

#include "app/verify/triangle_crossing.hpp"
#include "separating_axes.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

struct Case {
  const char* name;
  Corners a, b;
  bool crosses;
};

using Judge = std::optional<Vec3> (*)(const Corners&, const Corners&);

/// Compares both orders of the triangles, and all rotations of the corners after the shared ones.
void expect_all(Judge judge, std::size_t shared, std::span<const Case> cases) {
  for (const Case& c : cases) {
    Corners a = c.a, b = c.b;
    for (int turn = 0; turn < 3; ++turn) {
      EXPECT_EQ(judge(a, b).has_value(), c.crosses) << c.name;
      EXPECT_EQ(judge(b, a).has_value(), c.crosses) << c.name << ", the other way";
      std::rotate(a.begin() + static_cast<std::ptrdiff_t>(shared),
                  a.begin() + static_cast<std::ptrdiff_t>(shared) + 1, a.end());
    }
  }
}

constexpr Vec3 o(0, 0, 0), x(4, 0, 0), y(0, 4, 0), z(0, 0, 4);

TEST(TriangleCrossing, OfTrianglesThatShareNothing) {
  const Corners floor = {o, x, y};
  const Case cases[] = {
      {"pierced", floor, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(3, 3, 1)}, true},
      {"an edge above", floor, {Vec3(1, 1, 1), Vec3(1, 2, 1), Vec3(3, 3, 2)}, false},
      {"beside", floor, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(5, 5, 1)}, false},
      {"a corner on the surface", floor, {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(3, 3, 1)}, true},
      {"a corner on an edge", floor, {Vec3(2, 2, 0), Vec3(2, 2, 1), Vec3(3, 3, 1)}, true},
      {"a corner on a corner", floor, {Vec3(4, 0, 0), Vec3(5, 0, 1), Vec3(5, 1, 1)}, true},
      {"edges that cross", floor, {Vec3(2, -1, -1), Vec3(2, 1, 1), Vec3(2, -3, 3)}, true},
      {"edge on edge", floor, {Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(2, -1, 1)}, true},
      {"in line with an edge", floor, {Vec3(5, 0, 0), Vec3(7, 0, 0), Vec3(6, -1, 1)}, false},
      {"edge on surface", floor, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 1)}, true},
      {"one in the other, flat", floor, {Vec3(1, 1, 0), Vec3(1.5, 1, 0), Vec3(1, 1.5, 0)}, true},
      {"overlap, flat", floor, {Vec3(1, 1, 0), Vec3(9, 1, 0), Vec3(9, 9, 0)}, true},
      {"a star, flat", floor, {Vec3(2, -1, 0), Vec3(3, 3, 0), Vec3(-1, 1, 0)}, true},
      {"corners touch, flat", floor, {Vec3(4, 0, 0), Vec3(9, 0, 0), Vec3(9, 9, 0)}, true},
      {"edges touch, flat", floor, {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(9, 9, 0)}, true},
      {"apart, flat", floor, {Vec3(3, 2, 0), Vec3(9, 0, 0), Vec3(9, 9, 0)}, false},
      {"parallel", floor, {Vec3(0, 0, 1e-300), Vec3(4, 0, 1e-300), Vec3(0, 4, 1e-300)}, false},
      {"the last bit above", floor, {Vec3(1, 1, 5e-324), Vec3(1, 1, 1), Vec3(3, 3, 1)}, false},
      {"the last bit below", floor, {Vec3(1, 1, -5e-324), Vec3(1, 1, 1), Vec3(3, 3, 1)}, true},
      {"a needle through", floor, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 3)}, true},
      {"a needle on top", floor, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(3, 1, 0)}, true},
      {"a needle past", floor, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(3, 3, 3)}, false},
      {"a point on it", floor, {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)}, true},
      {"a point in its plane", floor, {Vec3(3, 3, 0), Vec3(3, 3, 0), Vec3(3, 3, 0)}, false},
      {"a point above", floor, {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)}, false},
      {"needles that cross", {o, x, 2.0 * x}, {Vec3(1, -1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, true},
      {"needles on one line", {o, x, 2.0 * x}, {Vec3(8, 0, 0), Vec3(9, 0, 0), Vec3(10, 0, 0)}, true},
      {"needles apart on one line", {o, x, 2.0 * x}, {Vec3(8.5, 0, 0), Vec3(9, 0, 0), Vec3(10, 0, 0)}, false},
      {"skew needles", {o, x, 2.0 * x}, {Vec3(1, -1, 1), Vec3(1, 0, 1), Vec3(1, 1, 1)}, false},
      {"equal points", {x, x, x}, {x, x, x}, true},
      {"other points", {x, x, x}, {y, y, y}, false},
  };
  expect_all(crossing_place, 0, cases);
}

TEST(TriangleCrossing, OfTrianglesThatShareAVertex) {
  const Case cases[] = {
      {"a fan", {o, x, y}, {o, -x, -y}, false},
      {"a fan, folded up", {o, x, y}, {o, x + z, y + z}, false},
      {"pierced", {o, x, y}, {o, Vec3(1, 1, 1), Vec3(1, 1, -1)}, true},
      {"pierces beyond the edge", {o, x, y}, {o, Vec3(5, 5, 1), Vec3(5, 5, -1)}, true},
      {"pierces its plane beside it", {o, x, y}, {o, Vec3(-1, 5, 1), Vec3(-1, 5, -1)}, false},
      {"an edge along an edge", {o, x, y}, {o, 0.5 * x, z}, true},
      {"an edge on the surface", {o, x, y}, {o, Vec3(1, 1, 0), z}, true},
      {"an edge on the surface and beyond", {o, x, y}, {o, Vec3(9, 9, 0), z}, true},
      {"an edge in the plane beside it", {o, x, y}, {o, Vec3(-1, 1, 0), z}, false},
      {"edges touch far off", {o, x, y}, {o, Vec3(2, 2, 0), Vec3(2, 2, 5)}, true},
      {"flat side by side", {o, x, y}, {o, y - x, -x}, false},
      {"flat and overlapping", {o, x, y}, {o, x + y, y - x}, true},
      {"another vertex at one place", {o, x, y}, {o, x, z}, true},
      {"a needle through the corner, off it", {o, x, y}, {o, z, -z}, false},
      {"a needle through the corner, on it", {o, x, y}, {o, x, -x}, true},
      {"a needle to the corner, on it", {o, x, y}, {o, Vec3(1, 1, 0), Vec3(2, 2, 0)}, true},
      {"a needle with two corners there", {o, x, y}, {o, o, z}, false},
      {"needles along each other", {o, x, 2.0 * x}, {o, 0.5 * x, -x}, true},
      {"needles back to back", {o, x, 2.0 * x}, {o, -x, -2.0 * x}, false},
      {"points", {o, o, o}, {o, o, o}, false},
  };
  expect_all(crossing_place_beside_vertex, 1, cases);
}

TEST(TriangleCrossing, OfTrianglesThatShareAnEdge) {
  const Case cases[] = {
      {"flat", {o, x, y}, {o, x, -y}, false},
      {"bent", {o, x, y}, {o, x, z}, false},
      {"nearly folded", {o, x, y}, {o, x, y + 1e-300 * z}, false},
      {"folded flat", {o, x, y}, {o, x, Vec3(2, 1, 0)}, true},
      {"folded flat, overhanging", {o, x, y}, {o, x, Vec3(9, 1, 0)}, true},
      {"folded flat, leaning apart", {o, x, Vec3(-9, 0.1, 0)}, {o, x, Vec3(13, 0.1, 0)}, true},
      {"folded flat and steep", {o, x, Vec3(-9, 1e-12, 0)}, {o, x, Vec3(13, 3e-12, 0)}, true},
      {"the same", {o, x, y}, {o, x, y}, true},
      {"a needle along the edge", {o, x, y}, {o, x, 0.5 * x}, false},
      {"a needle beyond the edge", {o, x, y}, {o, x, 2.0 * x}, false},
      {"needles beyond the edge", {o, x, 3.0 * x}, {o, x, 2.0 * x}, true},
      {"needles on either side", {o, x, -x}, {o, x, 2.0 * x}, false},
      {"an edge without length", {o, o, x}, {o, o, y}, false},
      {"an edge without length, along each other", {o, o, x}, {o, o, 2.0 * x}, true},
  };
  expect_all(crossing_place_beside_edge, 2, cases);
}

TEST(TriangleCrossing, IsAtAPlaceThatBothHave) {
  const Corners floor = {o, x, y};
  EXPECT_EQ(crossing_place(floor, {Vec3(1, 1, -1), Vec3(1, 1, 3), Vec3(1.5, 1.5, 1)}), Vec3(1, 1, 0));
  EXPECT_EQ(crossing_place(floor, {Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(1.5, -3, 0)}), Vec3(1, 0, 0));
  EXPECT_EQ(crossing_place(floor, {Vec3(2, -1, -1), Vec3(2, 1, 1), Vec3(2, -3, 3)}), Vec3(2, 0, 0));
  EXPECT_EQ(crossing_place(floor, {Vec3(1, 0, 0), Vec3(9, 0, 0), Vec3(5, -1, 0)}), Vec3(2.5, 0, 0));
  EXPECT_EQ(crossing_place_beside_vertex(floor, {o, Vec3(1, 1, 1), Vec3(1, 1, -1)}), Vec3(1, 1, 0));
  EXPECT_EQ(crossing_place_beside_edge(floor, {o, x, y}), Vec3(2, 0, 0));
}

// Corners have few different positions, so most pairs touch in some special way.
TEST(TriangleCrossing, IsThatOfWholeNumbers) {
  std::mt19937 random(11);  // NOLINT: the same triangles in every run
  std::uniform_int_distribution<int> coordinate(-2, 2);
  const Judge judges[] = {crossing_place, crossing_place_beside_vertex, crossing_place_beside_edge};
  int crossing[3] = {}, apart[3] = {};
  for (int i = 0; i < 30000; ++i) {
    const std::size_t shared = static_cast<std::size_t>(i) % 3;
    test::WholeCorners whole[2];
    Corners corners[2];
    for (std::size_t k = 0; k < 6; ++k) {
      test::Whole& p = whole[k / 3][k % 3];
      p = {coordinate(random), coordinate(random), coordinate(random)};
      if (k >= 3 && k - 3 < shared) {
        p = whole[0][k - 3];
      }
      // The offset makes metres affect the rounding; steps of 2^-12 m stay exact.
      corners[k / 3][k % 3] = Vec3(0.75, 1.5, -0.25) + 0x1p-12 * Vec3(p[0], p[1], p[2]);
    }
    if (shared > 0 && !(test::has_area(whole[0]) && test::has_area(whole[1]))) {
      continue;
    }
    const bool expected = test::do_cross(whole[0], whole[1], shared);
    ASSERT_EQ(judges[shared](corners[0], corners[1]).has_value(), expected)
        << "sharing " << shared << ", pair " << i;
    ++(expected ? crossing : apart)[shared];
  }
  for (std::size_t shared = 0; shared < 3; ++shared) {
    EXPECT_GT(crossing[shared], 100) << shared;
    EXPECT_GT(apart[shared], 100) << shared;
  }
}

}  // namespace
}  // namespace taut::app
