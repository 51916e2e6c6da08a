#include <gtest/gtest.h>

#include <array>

#include "renderer/passes/surface_pass.hpp"

namespace taut::renderer {
namespace {

// Clip space is the picture: two metres across are 1000 pixels.
constexpr glm::mat4 flat{1.0F};
constexpr std::array<glm::vec3, 3> corners{{{-0.2F, 0.1F, 0.0F}, {0.3F, 0.1F, 0.0F}, {0.3F, 0.5F, 0.0F}}};

PictureSettings large_picture() {
  PictureSettings settings;
  settings.width_px = 1000;
  settings.height_px = 500;
  return settings;
}

void expect_holds(const Tile& area, float left, float top, float right, float bottom) {
  const auto near = [](int found, float expected) { EXPECT_LE(std::abs(static_cast<float>(found) - expected), 40.0F); };
  EXPECT_LE(static_cast<float>(area.x_px), left);
  EXPECT_LE(static_cast<float>(area.y_px), top);
  EXPECT_GE(static_cast<float>(area.x_px + area.width_px), right);
  EXPECT_GE(static_cast<float>(area.y_px + area.height_px), bottom);
  near(area.x_px, left);
  near(area.y_px, top);
  near(area.x_px + area.width_px, right);
  near(area.y_px + area.height_px, bottom);
}

TEST(ScreenBounds, HoldsSurfacesLinesAndPointsAndLittleElse) {
  FrameView frame;
  SurfaceView surface;
  surface.positions = corners;
  const std::array surfaces{surface};
  expect_holds(screen_bounds(frame, surfaces, flat, large_picture()), 400.0F, 125.0F, 650.0F, 225.0F);
  LineView lines;
  lines.points = std::span(corners).first(2);
  lines.width_px = 60.0F;
  frame.lines.push_back(lines);
  expect_holds(screen_bounds(frame, {}, flat, large_picture()), 340.0F, 165.0F, 710.0F, 285.0F);
  frame.lines.clear();
  PointView points;
  points.centres = std::span(corners).last(1);
  points.diameter_px = 80.0F;
  frame.points.push_back(points);
  expect_holds(screen_bounds(frame, {}, flat, large_picture()), 570.0F, 45.0F, 730.0F, 205.0F);
}

TEST(ScreenBounds, IsEmptyWithoutAnythingAndOutsideThePicture) {
  EXPECT_EQ(screen_bounds({}, {}, flat, large_picture()).width_px, 0);
  std::array<glm::vec3, 3> outside = corners;
  for (glm::vec3& corner : outside) corner.x += 5.0F;
  SurfaceView surface;
  surface.positions = outside;
  const std::array surfaces{surface};
  EXPECT_LE(screen_bounds({}, surfaces, flat, large_picture()).width_px, 8);
}

TEST(ScreenBounds, IsEverythingWhenSomethingIsBehindTheEye) {
  glm::mat4 behind{1.0F};
  behind[3][3] = -1.0F;
  SurfaceView surface;
  surface.positions = corners;
  const std::array surfaces{surface};
  const Tile area = screen_bounds({}, surfaces, behind, large_picture());
  EXPECT_EQ(area.width_px, 1000);
  EXPECT_EQ(area.height_px, 500);
}

TEST(ReachesBelow, TellsWhetherTheFloorIsPassed) {
  SurfaceView surface;
  surface.positions = corners;
  const std::array surfaces{surface};
  EXPECT_TRUE(reaches_below(0.2F, {}, surfaces));
  EXPECT_FALSE(reaches_below(0.05F, {}, surfaces));
}

}  // namespace
}  // namespace taut::renderer
