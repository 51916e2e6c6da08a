#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "renderer/frame_view.hpp"
#include "renderer/surface/smooth_surface.hpp"

namespace taut::renderer {
namespace {

constexpr float no_limit = 1e9F;

// A fan around a middle vertex, in the xy plane.
struct Disc {
  std::vector<glm::vec3> positions{glm::vec3{0.0F}};
  std::vector<std::uint32_t> triangles;

  explicit Disc(std::uint32_t corners) {
    for (std::uint32_t i = 0; i < corners; ++i) {
      const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
      positions.emplace_back(std::cos(turn), std::sin(turn), 0.0F);
      triangles.insert(triangles.end(), {0, i + 1, (i + 1) % corners + 1});
    }
  }
};

// Returns the mean distance of triangles' middles from the sphere.
float distance_to_sphere(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const glm::vec3 middle =
        (positions[triangles[i]] + positions[triangles[i + 1]] + positions[triangles[i + 2]]) / 3.0F;
    sum += std::abs(1.0F - glm::length(middle));
  }
  return 3.0F * sum / static_cast<float>(triangles.size());
}

TEST(SmoothSurface, GoesThroughTheVertices) {
  const TriangleMesh ball = make_sphere(glm::vec3{0.0F}, 1.0F, 12);
  SmoothSurface smooth(ball.positions, ball.triangles, 2, {no_limit});
  smooth.place(ball.positions);
  ASSERT_GT(smooth.positions().size(), 4 * ball.positions.size());
  EXPECT_TRUE(std::equal(ball.positions.begin(), ball.positions.end(), smooth.positions().begin()));
  for (const glm::vec3& normal : smooth.normals()) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-5F);
}

TEST(SmoothSurface, ABallIsRounderThanItsTriangles) {
  const TriangleMesh ball = make_sphere(glm::vec3{0.0F}, 1.0F, 12);
  const float flat = distance_to_sphere(ball.positions, ball.triangles);
  SmoothSurface smooth(ball.positions, ball.triangles, 2, {no_limit});
  smooth.place(ball.positions);
  EXPECT_LT(distance_to_sphere(smooth.positions(), smooth.mesh().triangles()), 0.3F * flat);
}

TEST(SmoothSurface, BulgesNoMoreThanItMay) {
  const TriangleMesh ball = make_sphere(glm::vec3{0.0F}, 1.0F, 12);
  constexpr float most = 0.01F;
  for (const int levels : {1, 2, 3}) {
    SmoothSurface smooth(ball.positions, ball.triangles, levels, {most});
    smooth.place(ball.positions);
    std::vector<glm::vec3> flat = ball.positions;
    interpolate(std::span(smooth.mesh().parents()), flat);
    float farthest = 0.0F;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      farthest = std::max(farthest, glm::distance(flat[i], smooth.positions()[i]));
    }
    EXPECT_LE(farthest, most * 1.0001F) << levels;
    EXPECT_GT(farthest, 0.7F * most) << levels;
  }
}

TEST(SmoothSurface, TheBorderOfADiscIsRound) {
  const Disc disc(16);
  SmoothSurface smooth(disc.positions, disc.triangles, 2, {});
  smooth.place(disc.positions);
  float nearest = 1.0F;
  for (const LinkedBorderEdge& edge : smooth.mesh().border()) {
    nearest = std::min(nearest, glm::length(smooth.positions()[edge.ends[0]]));
  }
  const float of_polygon = std::cos(std::numbers::pi_v<float> / 16.0F);
  EXPECT_LT(1.0F - nearest, 0.1F * (1.0F - of_polygon));
}

TEST(SmoothSurface, CornersStayCorners) {
  const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  const std::vector<std::uint32_t> triangles{6, 0, 1, 6, 1, 2, 6, 2, 3, 6, 3, 4, 6, 4, 5, 6, 5, 0};
  SmoothSurface smooth(square, triangles, 2, {no_limit});
  smooth.place(square);
  for (const LinkedBorderEdge& edge : smooth.mesh().border()) {
    const glm::vec3& place = smooth.positions()[edge.ends[0]];
    EXPECT_TRUE(place.x * place.y * (2.0F - place.x) * (2.0F - place.y) == 0.0F) << place.x << ' ' << place.y;
  }
}

// A strip of squares whose columns are alternately above and below the plane.
struct Zigzag {
  std::vector<glm::vec3> flat;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;

  Zigzag() {
    constexpr std::uint32_t columns = 9, rows = 5;
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
      flat.emplace_back(i % columns, i / columns, 0.0F);
      positions.push_back(flat.back() + glm::vec3{0, 0, i % columns % 2 == 0 ? 0.1F : -0.1F});
      if (i % columns + 1 < columns && i + columns < columns * rows) {
        triangles.insert(triangles.end(), {i, i + 1, i + columns + 1, i, i + columns + 1, i + columns});
      }
    }
  }
};

TEST(SmoothSurface, WhatTurnsFromVertexToVertexIsFaired) {
  const Zigzag zigzag;
  SmoothSurface smooth(zigzag.flat, zigzag.triangles, 2, {0.0F, 1.0F});
  smooth.place(zigzag.positions);
  for (std::size_t v = 0; v < zigzag.flat.size(); ++v) {
    const glm::vec3& flat = zigzag.flat[v];
    const bool is_corner = (flat.x == 0.0F || flat.x == 8.0F) && (flat.y == 0.0F || flat.y == 4.0F);
    const glm::vec3 place = smooth.positions()[v];
    if (is_corner) {
      EXPECT_EQ(place, zigzag.positions[v]) << v;
    } else if (flat.x != 0.0F && flat.x != 8.0F) {
      EXPECT_LT(std::abs(place.z), 0.08F) << v;
    }
  }
}

TEST(SmoothSurface, IsFairedNoMoreThanItMay) {
  const Zigzag zigzag;
  SmoothSurface smooth(zigzag.flat, zigzag.triangles, 2, {0.0F, 0.01F});
  smooth.place(zigzag.positions);
  for (std::size_t v = 0; v < zigzag.flat.size(); ++v) {
    EXPECT_LE(glm::distance(smooth.positions()[v], zigzag.positions[v]), 0.0101F) << v;
  }
}

TEST(SmoothSurface, NeverLeavesItsRooms) {
  const Zigzag zigzag;
  SmoothSurface smooth(zigzag.flat, zigzag.triangles, 2, {1.0F, 1.0F});
  const std::vector<float> rooms(zigzag.flat.size(), 0.004F);
  smooth.place(zigzag.positions, rooms);
  std::vector<glm::vec3> coarse = zigzag.positions;
  interpolate(std::span(smooth.mesh().parents()), coarse);
  float farthest = 0.0F;
  for (std::size_t v = 0; v < coarse.size(); ++v) {
    farthest = std::max(farthest, std::abs(coarse[v].z - smooth.positions()[v].z));
  }
  EXPECT_LE(farthest, 0.00401F);
  EXPECT_GT(farthest, 0.002F);
}

// Another layer may be as near as the clearances say, below and beside the border.
TEST(SmoothSurface, BorderAndRimNeverLeaveTheirClearances) {
  constexpr float clearance = 0.004F;
  const Disc disc(9);
  SmoothSurface smooth(disc.positions, disc.triangles, 2, {1.0F, 1.0F}, 0.1F);
  smooth.place(disc.positions, std::vector<float>(disc.positions.size(), clearance));
  std::vector<glm::vec3> flat = disc.positions;
  interpolate(std::span(smooth.mesh().parents()), flat);
  for (std::size_t v = 0; v < flat.size(); ++v) {
    EXPECT_LE(glm::distance(flat[v], smooth.positions()[v]), 1.001F * clearance) << v;
  }
  float depth = 0.0F;
  for (const glm::vec3& place : smooth.positions()) depth = std::max(depth, -place.z);
  EXPECT_LE(depth, 1.001F * clearance);
  SmoothSurface alone(disc.positions, disc.triangles, 2, {1.0F, 1.0F}, 0.1F);
  alone.place(disc.positions);
  float lowest = 0.0F;
  for (const glm::vec3& place : alone.positions()) lowest = std::min(lowest, place.z);
  EXPECT_NEAR(lowest, -0.2F, 1e-6F);
}

TEST(SmoothSurface, LostClothStaysFinite) {
  const Disc disc(7);
  SmoothSurface smooth(disc.positions, disc.triangles, 2, {0.001F, 0.001F}, 0.001F);
  std::vector<glm::vec3> lost = disc.positions;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    constexpr float largest = std::numeric_limits<float>::max();
    lost[i] = i % 3 == 0 ? glm::vec3{largest, 0, -largest} : i % 3 == 1 ? glm::vec3{-largest} : glm::vec3{1e20F};
  }
  smooth.place(lost);
  for (const auto* values : {&smooth.positions(), &smooth.normals()}) {
    for (const glm::vec3& value : *values) {
      EXPECT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z));
    }
  }
}

TEST(SmoothSurface, AFlatSheetStaysFlat) {
  const Disc disc(7);
  SmoothSurface smooth(disc.positions, disc.triangles, 2, {no_limit});
  smooth.place(disc.positions);
  for (const glm::vec3& place : smooth.positions()) EXPECT_EQ(place.z, 0.0F);
  for (const glm::vec3& normal : smooth.normals()) EXPECT_EQ(normal, (glm::vec3{0, 0, 1}));
}

}  // namespace
}  // namespace taut::renderer
