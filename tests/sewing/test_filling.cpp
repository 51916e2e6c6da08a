// Flat panels filled with triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "app/garments/sewing/filling.hpp"

namespace taut::app {
namespace {

using sim::Vec2;

std::vector<Vec2> sample(const std::vector<Vec2>& corners, double edge) {
  std::vector<Vec2> outline;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 way = corners[(k + 1) % corners.size()] - corners[k];
    const int steps = std::max(1, static_cast<int>(std::round(glm::length(way) / edge)));
    for (int step = 0; step < steps; ++step) {
      outline.push_back(corners[k] + way * (static_cast<double>(step) / steps));
    }
  }
  return outline;
}

double polygon_area(const std::vector<Vec2>& outline) {
  double doubled = 0.0;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    doubled += sim::doubled_area(outline[0], outline[k], outline[k + 1]);
  }
  return 0.5 * doubled;
}

double min_angle_deg(const FilledOutline& filled) {
  double max_cosine = 0.0;
  for (const sim::Triangle& t : filled.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 at = filled.points_m[t[k]];
      max_cosine = std::max(max_cosine, glm::dot(glm::normalize(filled.points_m[t[(k + 1) % 3]] - at),
                                                 glm::normalize(filled.points_m[t[(k + 2) % 3]] - at)));
    }
  }
  return std::acos(max_cosine) * 57.29577951308232;
}

void expect_filled(const std::vector<Vec2>& outline, const FilledOutline& filled) {
  double area = 0.0;
  std::map<std::pair<sim::Index, sim::Index>, int> sides;
  for (const sim::Triangle& t : filled.triangles) {
    const double doubled = sim::doubled_area(filled.points_m[t[0]], filled.points_m[t[1]], filled.points_m[t[2]]);
    EXPECT_GT(doubled, 0.0);
    area += 0.5 * doubled;
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[{t[k], t[(k + 1) % 3]}];
    }
  }
  EXPECT_NEAR(area, polygon_area(outline), 1e-12);
  const auto count = static_cast<sim::Index>(outline.size());
  for (const auto& [side, times] : sides) {
    EXPECT_EQ(times, 1);
    const auto [a, b] = side;
    if (!sides.contains({b, a})) {
      EXPECT_EQ((a + 1) % count, b) << "a border that the outline does not have";
    } else {
      EXPECT_FALSE(a < count && b < count) << "an edge across the piece from border to border";
    }
  }
  for (sim::Index v = 0; v < count; ++v) {
    EXPECT_EQ(filled.points_m[v], outline[v]);
    EXPECT_TRUE(sides.contains({v, (v + 1) % count}));
  }
}

TEST(Filling, KeepsTheBordersOfASquareAndMakesNoNeedles) {
  const std::vector<Vec2> outline = sample({{0, 0}, {0.4, 0}, {0.4, 0.3}, {0, 0.3}}, 0.02);
  const FilledOutline filled = fill_outline(outline, 0.02);
  expect_filled(outline, filled);
  EXPECT_GT(min_angle_deg(filled), 20.0);
  EXPECT_NEAR(static_cast<double>(filled.triangles.size()), 0.12 / (0.4330127 * 4e-4), 120.0);
}

TEST(Filling, FillsAroundADartAndAlongANeckline) {
  std::vector<Vec2> corners = {{0, 0}, {0.3, 0}, {0.3, 0.4}, {0.2, 0.4}, {0.185, 0.3}, {0.17, 0.4}};
  for (int k = 1; k < 12; ++k) {
    const double angle = k * 3.14159265358979 / 12.0;
    corners.emplace_back(0.09 + 0.08 * std::cos(angle), 0.4 - 0.08 * std::sin(angle));
  }
  corners.emplace_back(0.0, 0.4);
  const std::vector<Vec2> outline = sample(corners, 0.02);
  const FilledOutline filled = fill_outline(outline, 0.02);
  expect_filled(outline, filled);
  EXPECT_GT(min_angle_deg(filled), 7.0);
}

TEST(Filling, FillsAStripThatIsNarrowerThanItsEdges) {
  const std::vector<Vec2> outline = sample({{0, 0}, {0.4, 0}, {0.4, 0.012}, {0, 0.012}}, 0.02);
  expect_filled(outline, fill_outline(outline, 0.02));
}

TEST(Filling, RefusesOutlinesThatCrossThemselvesOrGoClockwise) {
  EXPECT_THROW(fill_outline({{0, 0}, {1, 0}, {0, 0.9}, {1, 1}}, 0.1), std::invalid_argument);
  EXPECT_THROW(fill_outline({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 0.1), std::invalid_argument);
  EXPECT_THROW(fill_outline({{0, 0}, {1, 0}, {2, 0}}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace taut::app
