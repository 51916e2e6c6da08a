#include "renderer/depth_atlas.hpp"

#include <gtest/gtest.h>

#include <array>

namespace taut::renderer {
namespace {

constexpr std::array<std::uint32_t, 6> two_triangles{0, 1, 2, 0, 2, 3};

TEST(DepthAtlas, FillsTheCentresInsideAndKeepsTheNearest) {
  DepthAtlas atlas(2, 1, 8);
  const std::array<glm::vec3, 4> far{{{0, 0, 0.8F}, {1, 0, 0.8F}, {1, 1, 0.8F}, {0, 1, 0.8F}}};
  const std::array<glm::vec3, 4> near{
      {{0.25F, 0.25F, 0.2F}, {0.75F, 0.25F, 0.6F}, {0.75F, 0.75F, 0.6F}, {0.25F, 0.75F, 0.2F}}};
  atlas.draw(0, glm::mat4{1.0F}, near, two_triangles);
  atlas.draw(0, glm::mat4{1.0F}, far, two_triangles);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
      const float sloped = 0.2F + 0.8F * ((static_cast<float>(x) + 0.5F) / 8.0F - 0.25F);
      const float expected = x >= 8 ? 1.0F : inside ? sloped : 0.8F;
      EXPECT_NEAR(atlas.depths()[static_cast<std::size_t>(16 * y + x)], expected, 1e-5F) << x << "," << y;
    }
  }
  atlas.clear();
  EXPECT_EQ(atlas.depth_at({0.5F, 0.5F}), 1.0F);
}

TEST(DepthAtlas, WindingDoesNotMatterAndNothingLeavesTheCell) {
  DepthAtlas atlas(2, 1, 8);
  const std::array<glm::vec3, 3> large{{{-9, -9, 0.5F}, {-9, 9, 0.5F}, {20, 0, 0.5F}}};
  constexpr std::array<std::uint32_t, 3> triangle{0, 1, 2};
  atlas.draw(0, glm::mat4{1.0F}, large, triangle);
  EXPECT_EQ(atlas.depth_at({0.99F, 0.99F}), 0.5F);
  EXPECT_EQ(atlas.depth_at({1.01F, 0.5F}), 1.0F);
  EXPECT_EQ(atlas.depths()[8], 1.0F) << "the neighbouring cell";
}

TEST(DepthAtlas, NoGapsBetweenNeighboursAndNoTroubleWithNeedles) {
  DepthAtlas atlas(1, 1, 64);
  const std::array<glm::vec3, 5> fan{
      {{0, 0, 0.5F}, {1, 0, 0.5F}, {1, 1, 0.5F}, {0, 1, 0.5F}, {0.3137F, 0.7171F, 0.5F}}};
  constexpr std::array<std::uint32_t, 15> triangles{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 2, 2, 4};
  atlas.draw(0, glm::mat4{1.0F}, fan, triangles);
  for (const float depth : atlas.depths()) EXPECT_NEAR(depth, 0.5F, 1e-5F);
}

}  // namespace
}  // namespace taut::renderer
