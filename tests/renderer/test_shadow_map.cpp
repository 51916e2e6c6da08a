#include <gtest/gtest.h>

#include <array>

#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {
namespace {

constexpr std::array<std::uint32_t, 6> two_triangles{0, 1, 2, 0, 2, 3};

ShadowMap make_map(int side_px) {
  ShadowMap map;
  map.resize(side_px);
  return map;
}

TEST(ShadowMap, FillsTheCentresInsideAndKeepsTheNearest) {
  ShadowMap map = make_map(8);
  const std::array<glm::vec3, 4> far{{{0, 0, 0.8F}, {1, 0, 0.8F}, {1, 1, 0.8F}, {0, 1, 0.8F}}};
  const std::array<glm::vec3, 4> near{
      {{0.25F, 0.25F, 0.2F}, {0.75F, 0.25F, 0.6F}, {0.75F, 0.75F, 0.6F}, {0.25F, 0.75F, 0.2F}}};
  map.draw(glm::mat4{1.0F}, near, two_triangles);
  map.draw(glm::mat4{1.0F}, far, two_triangles);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
      const float sloped = 0.2F + 0.8F * ((static_cast<float>(x) + 0.5F) / 8.0F - 0.25F);
      const float expected = inside ? sloped : 0.8F;
      EXPECT_NEAR(map.depths()[static_cast<std::size_t>(8 * y + x)], expected, 1e-5F) << x << "," << y;
    }
  }
  map.clear();
  for (const float depth : map.depths()) EXPECT_EQ(depth, 1.0F);
}

TEST(ShadowMap, WindingDoesNotMatterAndNothingLeavesTheMap) {
  ShadowMap map = make_map(8);
  const std::array<glm::vec3, 3> large{{{-9, -9, 0.5F}, {-9, 9, 0.5F}, {20, 0, 0.5F}}};
  constexpr std::array<std::uint32_t, 3> triangle{0, 1, 2};
  map.draw(glm::mat4{1.0F}, large, triangle);
  EXPECT_EQ(map.depth_at({0.99F, 0.99F}), 0.5F);
  EXPECT_EQ(map.depth_at({1.01F, 0.5F}), 1.0F);
  constexpr std::array<std::uint32_t, 3> turned{0, 2, 1};
  map.clear();
  map.draw(glm::mat4{1.0F}, large, turned);
  EXPECT_EQ(map.depth_at({0.99F, 0.99F}), 0.5F);
}

TEST(ShadowMap, LeavesNoGapsBetweenNeighboursAndTakesNeedles) {
  ShadowMap map = make_map(64);
  const std::array<glm::vec3, 5> fan{
      {{0, 0, 0.5F}, {1, 0, 0.5F}, {1, 1, 0.5F}, {0, 1, 0.5F}, {0.3137F, 0.7171F, 0.5F}}};
  constexpr std::array<std::uint32_t, 15> triangles{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 2, 2, 4};
  map.draw(glm::mat4{1.0F}, fan, triangles);
  for (const float depth : map.depths()) EXPECT_NEAR(depth, 0.5F, 1e-5F);
}

TEST(ShadowMap, FillsNothingOutsideATriangle) {
  ShadowMap map = make_map(64);
  const std::array<glm::vec3, 3> corner{{{0.1F, 0.1F, 0.5F}, {0.9F, 0.2F, 0.5F}, {0.3F, 0.8F, 0.5F}}};
  constexpr std::array<std::uint32_t, 3> triangle{0, 1, 2};
  map.draw(glm::mat4{1.0F}, corner, triangle);
  int filled = 0;
  for (const float depth : map.depths()) filled += depth < 1.0F ? 1 : 0;
  // The triangle covers 0.27 of the map.
  EXPECT_NEAR(filled, 0.27 * 64 * 64, 30);
  for (const glm::ivec2 texel : {glm::ivec2{5, 5}, glm::ivec2{58, 30}, glm::ivec2{10, 40}}) {
    EXPECT_EQ(map.depths()[static_cast<std::size_t>(64 * texel.y + texel.x)], 1.0F);
  }
  EXPECT_LE(map.drawn().lower.x, 6);
  EXPECT_GE(map.drawn().upper.y, 51);
  EXPECT_LT(map.drawn().upper.y, 56);
}

}  // namespace
}  // namespace taut::renderer
