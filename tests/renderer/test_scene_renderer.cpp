#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/picture_target.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

TEST_F(SceneRendererTest, TriangleHasItsColourAndStandsUpright) {
  const Image image = renderer.draw(triangle_frame(), small_picture());
  ASSERT_EQ(image.width_px, 96);
  ASSERT_EQ(image.channels, 3);
  expect_colour(image, 48, 40, lit_by(sky_colour, rgb(0x2E8B57)), 1.0F);
  expect_colour(image, 26, 60, lit_by(sky_colour, rgb(0x2E8B57)), 1.0F);
  expect_colour(image, 26, 4, rgb(0xFFFFFF), 0.0F);
  expect_colour(image, 2, 60, rgb(0xFFFFFF), 0.0F);
}

TEST_F(SceneRendererTest, AKeptPictureIsShownAgainAndStretched) {
  const Image drawn = renderer.draw(triangle_frame(), small_picture());
  ColourTarget target(*context);
  renderer.draw_kept(triangle_frame(), small_picture());
  for (const int factor : {1, 2, 1}) {
    const unsigned framebuffer = target.framebuffer(factor * drawn.width_px, factor * drawn.height_px);
    clear_framebuffer(*context, framebuffer, factor * drawn.width_px, factor * drawn.height_px, 0.0F);
    renderer.show_kept(framebuffer, factor * drawn.width_px, factor * drawn.height_px);
    const Image shown = read_framebuffer(*context, framebuffer, factor * drawn.width_px, factor * drawn.height_px);
    expect_colour(shown, factor * 48, factor * 40, lit_by(sky_colour, rgb(0x2E8B57)), 1.0F);
    expect_colour(shown, factor * 26, factor * 4, rgb(0xFFFFFF), 0.0F);
    if (factor == 1) {
      EXPECT_EQ(shown.pixels, drawn.pixels);
    }
  }
}

TEST_F(SceneRendererTest, DrawingStraightToATargetLeavesTheRestOfItAndGivesTheSameBytes) {
  constexpr int border_px = 8;
  FrameView frame = triangle_frame();
  const std::array<std::array<std::uint32_t, 2>, 1> edge{{{0, 1}}};
  ColourTarget target(*context);
  for (const bool plain : {true, false}) {
    frame.backdrop.plain = plain;
    frame.ground_height_m = -1.2F;
    for (const int kind : {0, 1, 2}) {
      PictureSettings settings = small_picture();
      settings.samples = kind == 1 ? 4 : 1;
      frame.surfaces[0].wireframe.reset();
      if (kind == 2) frame.surfaces[0].wireframe = Wireframe{.edges = edge};
      const Image expected = renderer.draw(frame, settings);
      const int width_px = expected.width_px + border_px;
      const int height_px = expected.height_px + border_px;
      const unsigned framebuffer = target.framebuffer(width_px, height_px);
      clear_framebuffer(*context, framebuffer, width_px, height_px, 0.2F);
      EXPECT_EQ(renderer.draw_to(framebuffer, frame, settings), kind != 0);
      const Image shown = read_framebuffer(*context, framebuffer, width_px, height_px);
      for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x) {
          const bool inside = x < expected.width_px && y >= border_px;
          const int wanted = inside ? expected.at(x, y - border_px)[1] : 51;
          ASSERT_EQ(shown.at(x, y)[1], wanted) << x << "," << y << " kind " << kind;
        }
      }
    }
  }
}

// A triangle over a floor, lit from above.
FrameView shadow_frame() {
  FrameView frame = triangle_frame();
  frame.backdrop = {};
  frame.ground_height_m = -1.2F;
  frame.camera.eye = {0.0F, 1.5F, 4.0F};
  frame.lighting = Lighting{};
  frame.lighting.towards_key = {0.0F, 1.0F, 0.4F};
  return frame;
}

// The transparent picture, laid over white, equals the picture in front of white.
TEST_F(SceneRendererTest, ATransparentBackgroundKeepsClothAndShadow) {
  FrameView frame = shadow_frame();
  frame.camera.target.y = -0.8F;  // the shadow away from the lower edge
  frame.backdrop.upper_colour = frame.backdrop.lower_colour = rgb(0xFFFFFF);
  for (const int samples : {1, 4}) {
    for (const int supersampling : {1, 2}) {
      PictureSettings settings = small_picture();
      settings.samples = samples;
      settings.supersampling = supersampling;
      frame.backdrop.transparent = false;
      const Image white = renderer.draw(frame, settings);
      frame.backdrop.transparent = true;
      const Image drawn = renderer.draw(frame, settings);
      ASSERT_EQ(drawn.channels, 4);
      int clear = 0;
      int shadow = 0;
      int cloth = 0;
      for (int y = 0; y < drawn.height_px; ++y) {
        for (int x = 0; x < drawn.width_px; ++x) {
          const std::uint8_t* pixel = drawn.at(x, y);
          clear += pixel[3] == 0 ? 1 : 0;
          shadow += pixel[3] > 40 && pixel[3] < 200 && pixel[1] == 0 ? 1 : 0;
          cloth += pixel[3] == 255 ? 1 : 0;
          if (pixel[3] == 255 || pixel[1] == 0) {
            const int over_white = (pixel[1] * pixel[3] + 255 * (255 - pixel[3])) / 255;
            ASSERT_NEAR(over_white, white.at(x, y)[1], 3) << x << "," << y << " of " << samples;
          }
        }
      }
      EXPECT_GT(clear, 1000);
      EXPECT_GT(shadow, 50);
      EXPECT_GT(cloth, 300);
    }
  }
}

// A slow gradient rounded to eight bits has bands: columns of pixels that change all at once.
TEST_F(SceneRendererTest, GradientsHaveNoBands) {
  FrameView frame = triangle_frame();
  frame.surfaces.clear();
  frame.backdrop = {rgb(0xE0E0E0), rgb(0xE4E4E4)};
  PictureSettings settings = small_picture();
  settings.height_px = 256;
  const Image drawn = renderer.draw(frame, settings);
  int mixed_rows = 0;
  for (int y = 0; y < drawn.height_px; ++y) {
    const std::uint8_t* row = drawn.at(0, y);
    mixed_rows += std::any_of(row, row + 3 * drawn.width_px, [&](std::uint8_t c) { return c != row[0]; }) ? 1 : 0;
  }
  EXPECT_GT(mixed_rows, 60);
  frame.backdrop = {rgb(0x808080), rgb(0x808080)};
  const Image even = renderer.draw(frame, settings);
  EXPECT_TRUE(std::all_of(even.pixels.begin(), even.pixels.end(), [](std::uint8_t c) { return c == 0x80; }));
}

// Near a silhouette the near side is the steeper one.
TEST_F(SceneRendererTest, NothingOfTheFarSideShowsAlongASilhouette) {
  const TriangleMesh ball = make_sphere({0.0F, 0.0F, 0.0F}, 0.9F, 40);
  FrameView frame = triangle_frame();
  SurfaceView& surface = frame.surfaces[0];
  surface.positions = ball.positions;
  surface.normals = ball.normals;
  surface.triangles = ball.triangles;
  surface.style.outside_colour = rgb(0x00FF00);
  surface.style.inside_colour = rgb(0xFF0000);
  PictureSettings settings = small_picture();
  settings.samples = 1;
  settings.width_px = 480;
  settings.height_px = 320;
  const Image image = renderer.draw(frame, settings);
  int red = 0;
  int green = 0;
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      const std::uint8_t* pixel = image.at(x, y);
      red += pixel[0] > 100 && pixel[1] < 100 ? 1 : 0;
      green += pixel[1] > 100 && pixel[0] < 100 ? 1 : 0;
    }
  }
  EXPECT_GT(green, 50000);
  EXPECT_EQ(red, 0);
}

TEST_F(SceneRendererTest, TheOtherSideHasTheInsideColour) {
  FrameView frame = triangle_frame();
  frame.camera.eye.z = -4.0F;
  const Image image = renderer.draw(frame, small_picture());
  // The normal seen from inside points down to the studio's floor: half of the light, and warm.
  expect_colour(image, 48, 40, lit_by({0.565F, 0.55F, 0.52F}, rgb(0xC05020)), 2.0F);
}

TEST_F(SceneRendererTest, EveryGreyComesOutAsItWentIn) {
  for (int byte = 0; byte < 256; byte += 5) {
    FrameView frame;
    frame.camera = front_camera();
    frame.backdrop.plain = true;
    frame.backdrop.lower_colour = Colour{static_cast<float>(byte) / 255.0F};
    const Image image = renderer.draw(frame, small_picture());
    EXPECT_EQ(image.at(50, 30)[1], byte);
  }
}

TEST_F(SceneRendererTest, SamplesAndSupersamplingAverageInLinearLight) {
  for (const auto& [samples, supersampling] : {std::pair{4, 1}, std::pair{1, 4}}) {
    PictureSettings settings = small_picture();
    settings.samples = samples;
    settings.supersampling = supersampling;
    FrameView frame = triangle_frame();
    frame.surfaces[0].style.outside_colour = Colour{0.0F};
    const Image image = renderer.draw(frame, settings);
    // Pixels on the slanted edge are partly covered, in steps of a quarter or of a sixteenth of the light.
    int between = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 96; ++x) {
        const float light = srgb_to_linear(static_cast<float>(image.at(x, y)[0]) / 255.0F);
        const bool edge = light > 0.02F && light < 0.98F;
        between += edge ? 1 : 0;
        const float steps = light * (samples == 4 ? 4.0F : 16.0F);
        if (edge) {
          EXPECT_NEAR(steps, std::round(steps), 0.1F) << x << "," << y;
        }
      }
    }
    EXPECT_GT(between, 60);
  }
}

// A square sheet above a floor, seen from above at a slant.
struct Sheet {
  std::array<glm::vec3, 4> positions{
      {{-0.5F, 0.6F, 0.5F}, {0.5F, 0.6F, 0.5F}, {0.5F, 0.6F, -0.5F}, {-0.5F, 0.6F, -0.5F}}};
  std::array<glm::vec3, 4> normals{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};

  FrameView frame() const {
    FrameView view;
    SurfaceView surface;
    surface.positions = positions;
    surface.normals = normals;
    surface.triangles = triangles;
    view.surfaces.push_back(surface);
    view.ground_height_m = 0.0F;
    view.camera.eye = {0.0F, 3.0F, 3.0F};
    view.camera.target = {0.0F, 0.3F, 0.0F};
    view.camera.vertical_fov_rad = 0.9F;
    view.lighting.towards_key = {-1.0F, 1.0F, 0.0F};
    return view;
  }
};

// The pixel that shows a point of the world.
glm::ivec2 project_to_pixel(const glm::vec3& point, const Camera& camera, const PictureSettings& settings) {
  const float aspect = static_cast<float>(settings.width_px) / static_cast<float>(settings.height_px);
  const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4{point, 1.0F};
  return {static_cast<int>((0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(settings.width_px)),
          static_cast<int>((0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(settings.height_px))};
}

TEST_F(SceneRendererTest, ShadowFallsAwayFromTheKeyLight) {
  const Sheet sheet;
  const FrameView frame = sheet.frame();
  PictureSettings settings = small_picture();
  settings.shadow_map_px = 512;
  // The light is at 45 degrees on the left: the shadow's middle is as far to the right as the sheet is high.
  const glm::ivec2 in_shadow = project_to_pixel({0.7F, 0.0F, 0.2F}, frame.camera, settings);
  const glm::ivec2 in_light = project_to_pixel({-0.8F, 0.0F, 0.2F}, frame.camera, settings);
  const Image with = renderer.draw(frame, settings);
  settings.shadows = false;
  const Image without = renderer.draw(frame, settings);
  EXPECT_LT(with.at(in_shadow.x, in_shadow.y)[1], without.at(in_shadow.x, in_shadow.y)[1] - 30);
  EXPECT_GT(with.at(in_shadow.x, in_shadow.y)[1], 60) << "shadows are not black";
  EXPECT_EQ(with.at(in_light.x, in_light.y)[1], without.at(in_light.x, in_light.y)[1]);
}

TEST_F(SceneRendererTest, NoShadowIsCutByTheLowerEdge) {
  FrameView frame = shadow_frame();
  PictureSettings settings = small_picture();
  const auto darker_at = [&](float target_m, int from_below) {
    frame.camera.target.y = target_m;
    settings.shadows = true;
    const Image with = renderer.draw(frame, settings);
    settings.shadows = false;
    const Image without = renderer.draw(frame, settings);
    int most = 0;
    const int y = with.height_px - 1 - from_below;
    for (int x = 0; x < with.width_px; ++x) most = std::max(most, without.at(x, y)[1] - with.at(x, y)[1]);
    return most;
  };
  EXPECT_GT(darker_at(-0.6F, 20), 40);
  EXPECT_LT(std::max({darker_at(0.1F, 0), darker_at(0.1F, 1), darker_at(0.1F, 2)}), 20);
}

TEST_F(SceneRendererTest, FloorHidesWhatIsBelowIt) {
  Sheet sheet;
  for (glm::vec3& position : sheet.positions) position.y = 2.0F * position.z;  // half of it under the floor
  FrameView frame = sheet.frame();
  frame.surfaces[0].casts_shadow = false;
  const PictureSettings settings = small_picture();
  const Image with = renderer.draw(frame, settings);
  const glm::ivec2 above = project_to_pixel({0.0F, 0.3F, 0.15F}, frame.camera, settings);
  const glm::ivec2 below = project_to_pixel({0.0F, -0.3F, -0.15F}, frame.camera, settings);
  frame.surfaces.clear();
  const Image without = renderer.draw(frame, settings);
  EXPECT_LT(with.at(above.x, above.y)[0], without.at(above.x, above.y)[0] - 50);
  EXPECT_EQ(with.at(below.x, below.y)[0], without.at(below.x, below.y)[0]);
}

TEST_F(SceneRendererTest, SkyDarkensTheFloorUnderneath) {
  const Sheet sheet;
  FrameView frame = sheet.frame();
  frame.lighting.towards_key = {-1.0F, 0.05F, 0.0F};  // its shadow falls far outside the picture
  frame.camera.eye = {0.0F, 0.35F, 4.0F};             // looks under the sheet
  frame.camera.target = {0.0F, 0.25F, 0.0F};
  PictureSettings settings = small_picture();
  const glm::ivec2 below = project_to_pixel({0.0F, 0.0F, 0.0F}, frame.camera, settings);
  const Image open = renderer.draw(frame, settings);
  settings.sky_directions = 32;
  const Image closed = renderer.draw(frame, settings);
  EXPECT_LT(closed.at(below.x, below.y)[1], open.at(below.x, below.y)[1] - 10);
}

TEST_F(SceneRendererTest, SkyDarkensWhatIsBetweenTwoSheetsAndNothingAbove) {
  const Sheet sheet;
  FrameView frame = sheet.frame();
  std::array<glm::vec3, 4> lower = sheet.positions;
  for (glm::vec3& position : lower) position = {0.2F * position.x, 0.4F, 0.2F * position.z};
  frame.surfaces.push_back(frame.surfaces[0]);
  frame.surfaces[1].positions = lower;
  frame.lighting = flat_light();
  PictureSettings settings = small_picture();
  settings.width_px = 480;
  settings.height_px = 320;
  const Image open = renderer.draw(frame, settings);
  frame.camera.eye = {0.0F, 0.55F, 2.0F};  // looks between them
  frame.camera.target = {0.0F, 0.4F, 0.0F};
  const Image open_between = renderer.draw(frame, settings);
  const glm::ivec2 between = project_to_pixel({0.0F, 0.4F, 0.0F}, frame.camera, settings);
  settings.sky_directions = 12;
  const Image closed_between = renderer.draw(frame, settings);
  EXPECT_LT(closed_between.at(between.x, between.y)[2], open_between.at(between.x, between.y)[2] - 40);
  frame.camera = sheet.frame().camera;
  const Image closed = renderer.draw(frame, settings);
  const glm::ivec2 above = project_to_pixel({0.0F, 0.6F, 0.0F}, frame.camera, settings);
  EXPECT_NEAR(closed.at(above.x, above.y)[2], open.at(above.x, above.y)[2], 6);
}

TEST_F(SceneRendererTest, LitSheetHasNoAcne) {
  const Sheet sheet;
  FrameView frame = sheet.frame();
  PictureSettings settings = small_picture();
  frame.lighting.towards_key = {-1.0F, 0.3F, 0.2F};  // grazing: the hard case
  const Image with = renderer.draw(frame, settings);
  settings.shadows = false;
  const Image without = renderer.draw(frame, settings);
  for (float x = -0.45F; x <= 0.45F; x += 0.05F) {
    for (float z = -0.45F; z <= 0.45F; z += 0.05F) {
      const glm::ivec2 p = project_to_pixel({x, 0.6F, z}, frame.camera, settings);
      EXPECT_NEAR(with.at(p.x, p.y)[2], without.at(p.x, p.y)[2], 1) << x << "," << z;
    }
  }
}

TEST_F(SceneRendererTest, SameBytesEveryTimeAndFromEveryRenderer) {
  const Sheet sheet;
  const FrameView frame = sheet.frame();
  PictureSettings settings = small_picture();
  settings.sky_directions = 12;
  const Image first = renderer.draw(frame, settings);
  EXPECT_EQ(renderer.draw(frame, settings).pixels, first.pixels);
  PictureSettings other = settings;
  other.width_px = 50;
  other.samples = 1;
  other.shadow_map_px = 300;
  renderer.draw(triangle_frame(), other);
  EXPECT_EQ(renderer.draw(frame, settings).pixels, first.pixels) << "after something different";
  const auto second_context = create_context();
  SceneRenderer second(*second_context);
  EXPECT_EQ(second.draw(frame, settings).pixels, first.pixels);
  EXPECT_EQ(renderer.draw(frame, settings).pixels, first.pixels) << "with two contexts alive";
}

TEST_F(SceneRendererTest, PreparingChangesNoPicture) {
  const Sheet sheet;
  FrameView frame = sheet.frame();
  const std::array<float, 4> values{0.0F, 0.3F, 0.6F, 1.0F};
  for (const bool scalars : {false, true}) {
    if (scalars) frame.surfaces[0].scalars = ScalarColours{values};
    const Image expected = renderer.draw(frame, small_picture());
    SceneRenderer other(*context);
    other.prepare(small_picture(), scalars);
    EXPECT_EQ(other.draw(frame, small_picture()).pixels, expected.pixels);
  }
}

TEST_F(SceneRendererTest, TilesOfALargePictureFitTogether) {
  const Sheet sheet;
  const FrameView frame = sheet.frame();
  PictureSettings settings = small_picture();
  settings.width_px = 2100;  // two tiles across
  settings.height_px = 150;
  const Image tiled = renderer.draw(frame, settings);
  settings.supersampling = 2;  // three tiles across, cut elsewhere
  const Image differently = renderer.draw(frame, settings);
  double sum = 0.0;
  for (std::size_t i = 0; i < tiled.pixels.size(); ++i) {
    sum += std::abs(static_cast<int>(tiled.pixels[i]) - static_cast<int>(differently.pixels[i]));
  }
  EXPECT_LT(sum / static_cast<double>(tiled.pixels.size()), 0.3);
}

// Two sheets, one of them partly in the other's shadow.
TEST_F(SceneRendererTest, ShadingTwoByTwoPixelsAsOneKeepsOutlinesAndNearlyAllColours) {
  const Sheet sheet;
  FrameView frame = sheet.frame();
  const std::array<glm::vec3, 4> lower{
      {{-0.9F, 0.3F, 0.5F}, {0.3F, 0.3F, 0.5F}, {0.3F, 0.3F, -0.5F}, {-0.9F, 0.3F, -0.5F}}};
  frame.surfaces.push_back(frame.surfaces[0]);
  frame.surfaces[1].positions = lower;
  frame.surfaces[1].casts_shadow = false;
  frame.backdrop.plain = true;
  frame.backdrop.lower_colour = rgb(0xFF00FF);
  const std::array<float, 4> values{0.0F, 0.3F, 0.6F, 1.0F};
  PictureSettings settings = small_picture();
  settings.samples = 1;
  settings.width_px = 480;
  settings.height_px = 320;
  const auto is_free = [](const std::uint8_t* pixel) { return pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255; };
  for (const bool scalars : {false, true}) {
    if (scalars) frame.surfaces[0].scalars = ScalarColours{values};
    settings.shading_px = 1;
    const Image fine = renderer.draw(frame, settings);
    settings.shading_px = 2;
    const Image halved = renderer.draw(frame, settings);
    int far = 0;
    int near = 0;
    int spread = 0;  // free pixels that take a share of an outline
    for (int y = 0; y < fine.height_px; ++y) {
      for (int x = 0; x < fine.width_px; ++x) {
        const std::uint8_t* a = fine.at(x, y);
        const std::uint8_t* b = halved.at(x, y);
        ASSERT_TRUE(is_free(a) || !is_free(b)) << x << "," << y << " scalars " << scalars;
        spread += is_free(a) && !is_free(b) ? 1 : 0;
        if (is_free(a)) continue;
        const int difference = std::abs(a[1] - b[1]);
        far += difference > 12 ? 1 : 0;
        near += difference > 0 ? 1 : 0;
      }
    }
    EXPECT_GT(near, 100);
    EXPECT_LT(far, 600 + spread) << "scalars " << scalars;
    EXPECT_GT(spread, 100);
    EXPECT_LT(spread, 2000);
  }
}

TEST_F(SceneRendererTest, TheFirstPictureOfScalarsIsAsTheSecond) {
  FrameView frame = triangle_frame();
  const std::array<float, 3> values{0.0F, 0.5F, 1.0F};
  frame.surfaces[0].scalars = ScalarColours{values};
  PictureSettings settings = small_picture();
  settings.samples = 1;
  const Image first = renderer.draw(frame, settings);
  EXPECT_EQ(renderer.draw(frame, settings).pixels, first.pixels);
}

TEST_F(SceneRendererTest, ScalarsShowTheColourMap) {
  constexpr std::array low{0.0F, 0.0F, 0.0F};
  constexpr std::array high{5.0F, 5.0F, 5.0F};
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr std::array none{nan, nan, nan};
  FrameView frame = triangle_frame();
  const auto centre = [&](std::span<const float> values) {
    frame.surfaces[0].scalars = ScalarColours{values, 1.0F, 2.0F, ColourMap::viridis};
    const Image image = renderer.draw(frame, small_picture());
    const std::uint8_t* p = image.at(48, 40);
    return glm::ivec3{p[0], p[1], p[2]};
  };
  const glm::ivec3 dark = centre(low);
  EXPECT_GT(dark.b, dark.g + 40);
  const glm::ivec3 bright = centre(high);
  EXPECT_GT(bright.r, 200);
  EXPECT_LT(bright.b, 80);
  const glm::ivec3 grey = centre(none);
  EXPECT_EQ(grey.r, grey.b);
}

}  // namespace
}  // namespace taut::renderer
