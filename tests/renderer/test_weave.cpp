#include <algorithm>
#include <cmath>

#include "scene_support.hpp"

namespace taut::renderer {
namespace {

using WeaveTest = SceneRendererTest;

struct Brightness {
  double mean = 0.0;
  double deviation = 0.0;
};

// Returns the brightness inside the triangle, in steps of 255.
Brightness brightness(const Image& image) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int y = 44; y < 60; ++y) {
    for (int x = 36; x < 60; ++x) {
      const double value = image.at(x, y)[1];
      sum += value;
      squares += value * value;
      ++count;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

// The material is scaled and the camera stays, so that nothing but the look of the threads changes.
std::array<glm::vec3, 3> material(float scale) {
  auto coordinates = triangle_positions;
  for (glm::vec3& coordinate : coordinates) coordinate *= scale;
  return coordinates;
}

TEST_F(WeaveTest, ShowsUpCloseAndKeepsTheMean) {
  FrameView frame = triangle_frame();
  frame.surfaces[0].style.unevenness = 0.0F;
  const Brightness smooth = brightness(renderer.draw(frame, small_picture()));
  EXPECT_LT(smooth.deviation, 0.1);
  const auto close = material(0.004F);  // a stitch is 13 pixels wide
  frame.surfaces[0].material_coordinates = close;
  const Brightness woven = brightness(renderer.draw(frame, small_picture()));
  EXPECT_GT(woven.deviation, 1.5);
  EXPECT_NEAR(woven.mean, smooth.mean, 1.5);
  frame.surfaces[0].style.weave = 0.0F;
  EXPECT_LT(brightness(renderer.draw(frame, small_picture())).deviation, 0.1);
}

TEST_F(WeaveTest, YarnsAreUnevenAsFarAsTheStyleSays) {
  FrameView frame = triangle_frame();
  const auto near = material(0.02F);
  frame.surfaces[0].material_coordinates = near;
  frame.surfaces[0].style.threads_per_m = 1e5F;
  double before = -1.0;
  for (const float unevenness : {0.0F, 0.3F, 1.0F}) {
    frame.surfaces[0].style.unevenness = unevenness;
    const double deviation = brightness(renderer.draw(frame, small_picture())).deviation;
    EXPECT_GT(deviation, before + 0.5) << unevenness;
    before = deviation;
  }
}

TEST_F(WeaveTest, FadesBeforeItCouldAlias) {
  FrameView frame = triangle_frame();
  const Brightness smooth = brightness(renderer.draw(frame, small_picture()));
  for (const float scale : {0.5F, 1.0F, 10.0F, 1000.0F}) {
    const auto far = material(scale);
    frame.surfaces[0].material_coordinates = far;
    const Brightness woven = brightness(renderer.draw(frame, small_picture()));
    EXPECT_LT(woven.deviation, 0.1) << scale;
    EXPECT_NEAR(woven.mean, smooth.mean, 0.2) << scale;
  }
}

TEST_F(WeaveTest, EveryKindShowsUpCloseAndFades) {
  std::vector<Image> seen;
  for (const WeaveKind kind : all_weave_kinds) {
    FrameView frame = triangle_frame();
    frame.surfaces[0].style.weave_kind = kind;
    frame.surfaces[0].style.threads_per_m = 2700.0F;  // two periods of four across what is measured
    frame.surfaces[0].style.inside_colour = frame.surfaces[0].style.outside_colour;
    const Brightness smooth = brightness(renderer.draw(frame, small_picture()));
    const auto close = material(0.004F);
    frame.surfaces[0].material_coordinates = close;
    seen.push_back(renderer.draw(frame, small_picture()));
    EXPECT_GT(brightness(seen.back()).deviation, 1.2) << to_name(kind);
    // Uneven yarn is a little thicker here than elsewhere.
    EXPECT_NEAR(brightness(seen.back()).mean, smooth.mean, 8.0) << to_name(kind);
    for (std::size_t k = 0; k + 1 < seen.size(); ++k) EXPECT_NE(seen[k].pixels, seen.back().pixels);
    const auto far = material(3.0F);
    frame.surfaces[0].material_coordinates = far;
    EXPECT_LT(brightness(renderer.draw(frame, small_picture())).deviation, 0.2) << to_name(kind);
  }
}

// Denim: white weft between blue warp.
TEST_F(WeaveTest, TwillShowsTheOtherSidesColourBetweenItsOwn) {
  FrameView frame = triangle_frame();
  const auto close = material(0.004F);
  frame.surfaces[0].material_coordinates = close;
  frame.surfaces[0].style.outside_colour = rgb(0x802020);
  const auto differs = [&](WeaveKind kind) {
    frame.surfaces[0].style.weave_kind = kind;
    frame.surfaces[0].style.inside_colour = frame.surfaces[0].style.outside_colour;
    const Image same = renderer.draw(frame, small_picture());
    frame.surfaces[0].style.inside_colour = rgb(0x2020FF);
    return renderer.draw(frame, small_picture()).pixels != same.pixels;
  };
  EXPECT_TRUE(differs(WeaveKind::twill));
  EXPECT_FALSE(differs(WeaveKind::plain));
}

TEST_F(WeaveTest, SatinShinesWideAcrossItsWarp) {
  constexpr std::array<glm::vec3, 3> towards_eye{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  FrameView frame = triangle_frame();
  frame.surfaces[0].normals = towards_eye;
  const auto far = material(3.0F);
  frame.surfaces[0].material_coordinates = far;
  frame.surfaces[0].style.roughness = 0.45F;
  frame.lighting.ambient = 0.0F;
  frame.lighting.key = 1.0F;
  const auto lit_from = [&](WeaveKind kind, const glm::vec3& towards_key) {
    frame.surfaces[0].style.weave_kind = kind;
    frame.lighting.towards_key = towards_key;
    return brightness(renderer.draw(frame, small_picture())).mean;
  };
  const glm::vec3 aside{0.8F, 0.0F, 1.0F}, above{0.0F, 0.8F, 1.0F};
  const double round = lit_from(WeaveKind::knit, aside) - lit_from(WeaveKind::knit, above);
  EXPECT_GT(lit_from(WeaveKind::satin, aside) - lit_from(WeaveKind::satin, above), round + 4.0);
}

TEST_F(WeaveTest, ColoursOfScalarsStaySmooth) {
  constexpr std::array values{0.5F, 0.5F, 0.5F};
  FrameView frame = triangle_frame();
  frame.surfaces[0].scalars = ScalarColours{values};
  const Image smooth = renderer.draw(frame, small_picture());
  const auto close = material(0.004F);
  frame.surfaces[0].material_coordinates = close;
  EXPECT_EQ(renderer.draw(frame, small_picture()).pixels, smooth.pixels);
}

}  // namespace
}  // namespace taut::renderer
