#include <array>

#include "scene_support.hpp"

namespace taut::renderer {
namespace {

using MarksTest = SceneRendererTest;

TEST_F(MarksTest, BlendingIsInLinearLight) {
  FrameView frame = triangle_frame();
  frame.surfaces.clear();
  const std::array<glm::vec3, 2> ends{{{-2, 0, 0}, {2, 0, 0}}};
  frame.lines.push_back({ends, Colour{0.0F}, 20.0F, 0.5F});
  const Image image = renderer.draw(frame, small_picture());
  // Half the light of white is 188, not 128.
  EXPECT_NEAR(image.at(48, 32)[0], 188, 1);
}

TEST_F(MarksTest, LineHasItsWidth) {
  for (const float width_px : {1.0F, 3.0F, 7.0F}) {
    FrameView frame = triangle_frame();
    frame.surfaces.clear();
    const std::array<glm::vec3, 2> ends{{{-2, 0, 0}, {2, 0, 0}}};
    frame.lines.push_back({ends, Colour{0.0F}, width_px});
    const Image image = renderer.draw(frame, small_picture());
    float covered = 0.0F;
    for (int y = 0; y < 64; ++y) {
      covered += 1.0F - srgb_to_linear(static_cast<float>(image.at(40, y)[0]) / 255.0F);
    }
    EXPECT_NEAR(covered, width_px, 0.15F);
  }
}

TEST_F(MarksTest, WireframeLiesOnBothSides) {
  constexpr std::array<std::array<std::uint32_t, 2>, 1> edge{{{0, 2}}};
  for (const float side : {1.0F, -1.0F}) {
    FrameView frame = triangle_frame();
    frame.camera.eye = {side * 3.0F, 0.3F, side * 2.5F};
    frame.surfaces[0].wireframe = Wireframe{edge, Colour{1.0F, 0.0F, 1.0F}, 6.0F, 1.0F};
    const Image image = renderer.draw(frame, small_picture());
    int magenta = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
      magenta += image.pixels[i] > 250 && image.pixels[i + 1] < 5 && image.pixels[i + 2] > 250 ? 1 : 0;
    }
    EXPECT_GT(magenta, 150) << "seen from side " << side;
  }
}

TEST_F(MarksTest, LinesAreHiddenBehindSurfacesUnlessAskedFor) {
  FrameView frame = triangle_frame();
  const std::array<glm::vec3, 2> ends{{{-2, -0.3F, -0.5F}, {2, -0.3F, -0.5F}}};
  frame.lines.push_back({ends, Colour{0.0F}, 5.0F});
  const int row = 41;
  Image image = renderer.draw(frame, small_picture());
  EXPECT_GT(image.at(48, row)[1], 100);
  EXPECT_LT(image.at(10, row)[1], 5);
  frame.lines[0].hidden_by_surfaces = false;
  image = renderer.draw(frame, small_picture());
  EXPECT_LT(image.at(48, row)[1], 5);
}

TEST_F(MarksTest, PinsAreSeen) {
  FrameView frame = triangle_frame();
  const std::array centres{glm::vec3{0.0F, 0.0F, 0.3F}};
  frame.spheres.push_back({centres, 0.2F, rgb(0xC0392B)});
  const Image image = renderer.draw(frame, small_picture());
  EXPECT_GT(image.at(48, 32)[0], image.at(48, 32)[1] + 60);
}

}  // namespace
}  // namespace taut::renderer
