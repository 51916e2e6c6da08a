#include <gtest/gtest.h>

#include <array>

#include "renderer/light/studio_light.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

// A level sheet of 1 m by 1 m at a height, its outside up.
struct Sheet {
  std::array<glm::vec3, 4> positions;
  std::array<glm::vec3, 4> normals{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};

  explicit Sheet(float height_m)
      : positions{{{-0.5F, height_m, 0.5F},
                   {0.5F, height_m, 0.5F},
                   {0.5F, height_m, -0.5F},
                   {-0.5F, height_m, -0.5F}}} {}
  SurfaceView view() const { return make_surface(positions, normals, triangles); }
};

// Returns the light at one point whose normal points up.
glm::vec2 light_at(SkyLight& sky, const glm::vec3& point) {
  const std::array<glm::vec3, 1> position{point};
  const std::array<glm::vec3, 1> normal{{{0, 1, 0}}};
  SurfaceView surface;
  surface.positions = position;
  surface.normals = normal;
  std::vector<glm::vec2> light;
  sky.gather(surface, light);
  return light.front();
}

TEST(SkyLight, AnOpenSkyIsWholeAboveAndHalfBelow) {
  SkyLight sky;
  sky.draw_maps({}, std::nullopt, 24);
  EXPECT_NEAR(light_at(sky, {}).x, 1.0F, 1e-5F);
  EXPECT_NEAR(light_at(sky, {}).y, 0.5F, 1e-5F);
  // The same light is now a sum over directions.
  const Sheet sheet(0.0F);
  const SurfaceView view = sheet.view();
  const std::array casters{&view};
  sky.draw_maps(casters, bounding_box(sheet.positions), 64);
  EXPECT_NEAR(light_at(sky, {}).x, 1.0F, 0.1F) << "a sheet is hardly in its own way";
  EXPECT_NEAR(light_at(sky, {}).y, 0.5F, 0.05F);
}

TEST(SkyLight, WhatIsBetweenTwoSheetsIsDark) {
  const Sheet low(0.0F);
  const Sheet high(0.2F);
  const SurfaceView low_view = low.view();
  const SurfaceView high_view = high.view();
  const std::array casters{&low_view, &high_view};
  SkyLight sky;
  sky.draw_maps(casters, unite(bounding_box(low.positions), bounding_box(high.positions)), 64);
  EXPECT_LT(light_at(sky, {}).x, 0.3F);
  EXPECT_GT(light_at(sky, {}).y, 0.45F);
  EXPECT_GT(light_at(sky, {0, 0.2F, 0}).x, 0.9F);
  EXPECT_LT(light_at(sky, {0, 0.2F, 0}).y, 0.15F);
}

TEST(SkyLight, TheFloorIsDarkestUnderneathAndUndisturbedByWhatIsBelowIt) {
  const Sheet sheet(0.2F);
  const SurfaceView view = sheet.view();
  const std::array casters{&view};
  SkyLight sky;
  sky.draw_maps(casters, bounding_box(sheet.positions), 24);
  const glm::vec4 area{-2.0F, -2.0F, 0.25F, 0.25F};
  constexpr std::size_t side = SkyLight::floor_px;
  std::vector<float> light;
  sky.gather_floor(area, 0.0F, light);
  ASSERT_EQ(light.size(), side * side);
  EXPECT_LT(light[side * side / 2 + side / 2], 0.4F);
  EXPECT_NEAR(light.front(), 1.0F, 1e-4F);
  EXPECT_GT(light[side * side / 2 + side / 8], 0.9F);
  sky.gather_floor(area, 0.4F, light);
  for (const float share : light) EXPECT_GT(share, 0.999F);
}

}  // namespace
}  // namespace taut::renderer
