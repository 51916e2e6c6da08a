#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "renderer/frame_view.hpp"

namespace taut::renderer {
namespace {

constexpr Box shirt{{-0.4F, 0.1F, -0.2F}, {0.5F, 1.3F, 0.3F}};

// The largest |x| and |y| of the box's corners on the picture, where 1 is its edge.
glm::vec2 extent_on_picture(const Box& box, const Camera& camera, float aspect) {
  glm::vec2 extent{0.0F};
  for (unsigned i = 0; i < 8; ++i) {
    const glm::vec3 corner{(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
                           (i & 4U) != 0 ? box.upper.z : box.lower.z};
    const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4{corner, 1.0F};
    EXPECT_GT(clip.z, -clip.w) << "in front of the near plane";
    EXPECT_LT(clip.z, clip.w) << "behind the far plane";
    extent = {std::max(extent.x, std::abs(clip.x / clip.w)), std::max(extent.y, std::abs(clip.y / clip.w))};
  }
  return extent;
}

TEST(FitCameraToBox, FillsThePictureUpToTheMarginFromEverySide) {
  for (const float aspect : {0.5F, 1.0F, 16.0F / 9.0F, 4.0F}) {
    for (const float azimuth : {0.0F, 0.7F, 2.0F, 4.5F}) {
      for (const float elevation : {-0.4F, 0.0F, 0.5F, 1.2F}) {
        const Camera camera = fit_camera_to_box(shirt, {azimuth, elevation, 0.5F, 0.1F}, aspect);
        const glm::vec2 extent = extent_on_picture(shirt, camera, aspect);
        EXPECT_NEAR(std::max(extent.x, extent.y), 0.8F, 1e-3F) << aspect << " " << azimuth << " " << elevation;
      }
    }
  }
}

TEST(FitCameraToBox, AzimuthZeroLooksFromPlusZAndAQuarterTurnFromPlusX) {
  const Camera front = fit_camera_to_box(shirt, {0.0F, 0.0F, 0.5F, 0.1F}, 1.0F);
  EXPECT_GT(front.eye.z, 1.0F);
  EXPECT_NEAR(front.eye.x, front.target.x, 1e-4F);
  const Camera side = fit_camera_to_box(shirt, {1.5707963F, 0.0F, 0.5F, 0.1F}, 1.0F);
  EXPECT_GT(side.eye.x, 1.0F);
  EXPECT_NEAR(side.eye.z, side.target.z, 1e-4F);
}

TEST(FitCameraToBox, TakesABoxWithoutExtent) {
  const Camera camera = fit_camera_to_box({glm::vec3{1.0F}, glm::vec3{1.0F}}, {}, 1.0F);
  EXPECT_TRUE(std::isfinite(camera.eye.z));
  EXPECT_GT(camera.eye.z, 1.0F);
  EXPECT_GT(camera.near_m, 0.0F);
}

TEST(FitCameraToBox, RefusesWhatHasNoAnswer) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(fit_camera_to_box({{0.0F, nan, 0.0F}, {1.0F, 1.0F, 1.0F}}, {}, 1.0F), std::invalid_argument);
  EXPECT_THROW(fit_camera_to_box({{1.0F, 1.0F, 1.0F}, {0.0F, 0.0F, 0.0F}}, {}, 1.0F), std::invalid_argument);
  EXPECT_THROW(fit_camera_to_box(shirt, {}, 0.0F), std::invalid_argument);
  EXPECT_THROW(fit_camera_to_box(shirt, {0.0F, 0.0F, 0.5F, 0.5F}, 1.0F), std::invalid_argument);
}

// A ball fills less of a picture than the box around it.
TEST(FitCameraToPoints, FillsThePictureUpToTheMargin) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 400; ++i) {
    const float height = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / 400.0F;
    const float turn = 2.399963F * static_cast<float>(i);
    const float radius = std::sqrt(1.0F - height * height);
    points.emplace_back(5.0F + radius * std::cos(turn), height, radius * std::sin(turn));
  }
  for (const float aspect : {0.5F, 2.0F}) {
    const Camera camera = fit_camera_to_points(points, {0.7F, 0.4F, 0.5F, 0.1F}, aspect);
    float extent = 0.0F;
    for (const glm::vec3& point : points) {
      const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4{point, 1.0F};
      extent = std::max({extent, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
    EXPECT_NEAR(extent, 0.8F, 1e-3F) << aspect;
  }
}

TEST(FitCameraToPoints, FourPointsDecideIt) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 400; ++i) {
    const auto t = static_cast<float>(i);
    points.emplace_back(std::sin(1.7F * t), 0.6F * std::sin(2.9F * t), 0.8F * std::sin(0.31F * t));
  }
  const Framing framing{0.7F, 0.3F, 0.4F, 0.1F};
  const Camera all = fit_camera_to_points(points, framing, 1.6F);
  const Camera four = fit_camera_to_points(outermost_points(points, framing, 1.6F), framing, 1.6F);
  EXPECT_LT(glm::distance(all.eye, four.eye), 1e-4F);
  const auto view = [](const Camera& camera) { return glm::normalize(camera.target - camera.eye); };
  EXPECT_LT(glm::distance(view(all), view(four)), 1e-4F);
}

TEST(FitCameraToPoints, TakesOnePointAndRefusesNone) {
  EXPECT_TRUE(std::isfinite(fit_camera_to_points(std::array{glm::vec3{1.0F}}, {}, 1.0F).eye.z));
  EXPECT_THROW(fit_camera_to_points({}, {}, 1.0F), std::invalid_argument);
}

TEST(BoundingBox, HoldsEveryPoint) {
  constexpr std::array points{glm::vec3{1, 2, 3}, glm::vec3{-1, 5, 0}};
  const Box box = bounding_box(points);
  EXPECT_EQ(box.lower, (glm::vec3{-1, 2, 0}));
  EXPECT_EQ(box.upper, (glm::vec3{1, 5, 3}));
  EXPECT_THROW(bounding_box({}), std::invalid_argument);
}

}  // namespace
}  // namespace taut::renderer
