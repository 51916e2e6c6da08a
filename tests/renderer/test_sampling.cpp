#include "renderer/light/light_maps.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

// A ball above a floor, in its shadow and light.
struct BallScene {
  TriangleMesh ball = make_sphere({0.0F, 0.3F, 0.0F}, 0.5F, 32);

  FrameView frame() const {
    FrameView frame;
    frame.surfaces.push_back(make_surface(ball.positions, ball.normals, ball.triangles));
    frame.ground_height_m = -0.6F;
    frame.camera = front_camera();
    frame.camera.eye.y = 1.5F;
    frame.lighting = studio_lighting(frame.camera);
    return frame;
  }
};

PictureSettings sampled_picture(int passes) {
  PictureSettings settings = small_picture();
  settings.passes = passes;
  return settings;
}

// Returns the root of the mean squared difference as a fraction of white.
double rms_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = (static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i])) / 255.0;
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

TEST(PassSample, SpreadsEvenlyOverPixelLampAndSky) {
  constexpr int count = 64;
  glm::vec2 offset{0.0F};
  glm::vec2 lamp{0.0F};
  glm::vec3 sky{0.0F};
  for (int i = 0; i < count; ++i) {
    const PassSample sample = make_pass_sample(i, count);
    EXPECT_LE(glm::length(sample.lamp_point), 1.0F);
    offset += sample.pixel_offset / static_cast<float>(count);
    lamp += sample.lamp_point / static_cast<float>(count);
    for (const glm::vec3& towards : sample.towards_sky) {
      EXPECT_NEAR(glm::length(towards), 1.0F, 1e-5F);
      sky += towards / static_cast<float>(count * sky_pairs_of_pass);
    }
  }
  EXPECT_LT(glm::length(offset), 0.04F);
  EXPECT_LT(glm::length(lamp), 0.05F);
  EXPECT_NEAR(sky.y, 0.5F, 1e-5F) << "all heights alike, as on a sphere";
  EXPECT_LT(std::hypot(sky.x, sky.z), 0.05F);
}

TEST_F(SceneRendererTest, PassesConverge) {
  const BallScene scene;
  const Image few = renderer.draw(scene.frame(), sampled_picture(64));
  const Image many = renderer.draw(scene.frame(), sampled_picture(1024));
  EXPECT_LT(rms_difference(few, many), 0.01);
  EXPECT_GT(rms_difference(renderer.draw(scene.frame(), sampled_picture(2)), many), 0.01);
}

TEST_F(SceneRendererTest, PassesHaveTheBrightnessOfASinglePicture) {
  const BallScene scene;
  PictureSettings settings = small_picture();
  settings.samples = 4;
  settings.sky_directions = 32;
  const Image sampled = renderer.draw(scene.frame(), sampled_picture(64));
  EXPECT_LT(rms_difference(renderer.draw(scene.frame(), settings), sampled), 0.03);
}

TEST_F(SceneRendererTest, PassesGiveTheSameBytesEveryTime) {
  const BallScene scene;
  const Image first = renderer.draw(scene.frame(), sampled_picture(5));
  renderer.draw(scene.frame(), small_picture());
  EXPECT_EQ(renderer.draw(scene.frame(), sampled_picture(5)).pixels, first.pixels);
}

TEST_F(SceneRendererTest, PassesAreReportedAndCanBeGivenUp) {
  const BallScene scene;
  int reported = 0;
  renderer.set_pass_report([&](int done, int all) {
    EXPECT_EQ(done, ++reported);
    EXPECT_EQ(all, 3);
  });
  renderer.draw(scene.frame(), sampled_picture(3));
  EXPECT_EQ(reported, 3);
  renderer.set_pass_report([](int, int) { throw std::runtime_error("enough"); });
  EXPECT_THROW(renderer.draw(scene.frame(), sampled_picture(3)), std::runtime_error);
}

TEST_F(SceneRendererTest, PassesShowMarksAndPlainBackdrops) {
  FrameView frame = triangle_frame();
  frame.lighting.ambient = 0.0F;
  const std::array<glm::vec3, 2> line{{{-2.0F, 0.9F, 0.0F}, {2.0F, 0.9F, 0.0F}}};
  const Colour red = rgb(0xC00000);
  frame.lines.push_back({.points = line, .colour = red, .width_px = 8.0F});
  const Image image = renderer.draw(frame, sampled_picture(4));
  expect_colour(image, 2, 40, rgb(0xFFFFFF), 1.0F);
  expect_colour(image, 48, 40, rgb(0x000000), 1.0F);
  expect_colour(image, 8, 3, red, 1.0F);
}

}  // namespace
}  // namespace taut::renderer
