#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/light/surface_buffers.hpp"
#include "renderer/passes/backdrop_pass.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

// A level square grid around the y axis.
struct Grid {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> triangles;

  Grid(int cells, float side_m, float height_m) {
    for (int z = 0; z <= cells; ++z) {
      for (int x = 0; x <= cells; ++x) {
        const glm::vec2 place = glm::vec2(x, z) / static_cast<float>(cells) - 0.5F;
        positions.emplace_back(side_m * place.x, height_m, side_m * place.y);
        normals.emplace_back(0, 1, 0);
      }
    }
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t z = 0; z + 1 < row; ++z) {
      for (std::uint32_t x = 0; x + 1 < row; ++x) {
        const std::uint32_t i = z * row + x;
        triangles.insert(triangles.end(), {i, i + row, i + 1, i + 1, i + row, i + row + 1});
      }
    }
  }
  SurfaceView view() const { return make_surface(positions, normals, triangles); }
};

// A small sheet above a large one, lit from straight above.
struct TwoSheets {
  Grid low;
  Grid high;
  FrameView frame;
  FrameBlock block;

  explicit TwoSheets(int cells, float gap_m = 0.3F) : low(cells, 1.0F, 0.0F), high(8, 0.4F, gap_m) {
    frame.surfaces = {low.view(), high.view()};
    frame.lighting.towards_key = {0, 1, 0};
    frame.ground_height_m = -0.2F;
    frame.camera.eye = {0, 2, 3};
    const Box box = unite(bounding_box(low.positions), bounding_box(high.positions));
    block = make_frame_block(frame, PictureSettings{}, box);
  }
  std::vector<KeyVisibility> visibility() {
    const std::array casters{&frame.surfaces[0], &frame.surfaces[1]};
    ShadowMap map;
    map.resize(1024);
    for (const SurfaceView* caster : casters) {
      map.draw(block.world_to_shadow, caster->positions, caster->triangles);
    }
    ShadowClassifier classifier;
    classifier.set_shadow_map(map, block);
    std::vector<KeyVisibility> triangles;
    classifier.classify(frame.surfaces[0], triangles);
    return triangles;
  }
  // Returns the distances of a triangle's nearest and farthest corner, in the large sheet, from the middle, measured as
  // the larger of |x| and |z|.
  glm::vec2 reach_m(std::size_t triangle) const {
    glm::vec2 reach{1e9F, 0.0F};
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 p = low.positions[low.triangles[3 * triangle + k]];
      const float own = std::max(std::abs(p.x), std::abs(p.z));
      reach = {std::min(reach.x, own), std::max(reach.y, own)};
    }
    return reach;
  }
};

TEST(ShadowClassifier, AFineMeshHasLightShadowAndTheirEdge) {
  TwoSheets scene(50);
  const std::vector<KeyVisibility> visibility = scene.visibility();
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    const glm::vec2 reach_m = scene.reach_m(i);
    if (reach_m.y < 0.13F) {
      EXPECT_EQ(visibility[i], KeyVisibility::shadowed) << reach_m.y;
    }
    if (reach_m.x > 0.27F) {
      EXPECT_EQ(visibility[i], KeyVisibility::lit) << reach_m.x;
    }
    // The shadow's edge is at 0.2; the penumbra reaches as far as the widest blur.
    if (reach_m.x < 0.2F && reach_m.y > 0.2F) {
      EXPECT_EQ(visibility[i], KeyVisibility::partial) << reach_m.x;
    }
  }
  EXPECT_GT(std::count(visibility.begin(), visibility.end(), KeyVisibility::shadowed), 300);
  EXPECT_LT(std::count(visibility.begin(), visibility.end(), KeyVisibility::partial), 1000);
}

// The mesh is finer than the penumbra is wide.
TEST(ShadowClassifier, PenumbraSpreadsOverSeveralTriangles) {
  TwoSheets scene(200);
  const std::vector<KeyVisibility> visibility = scene.visibility();
  const float blur_m = scene.block.shadow_blur.x * scene.block.shadow.x;
  ASSERT_GT(blur_m, 0.011F);
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    const glm::vec2 reach_m = scene.reach_m(i);
    if (std::abs(reach_m.x - 0.2F) < 0.8F * blur_m) {
      EXPECT_EQ(visibility[i], KeyVisibility::partial) << reach_m.x;
    }
  }
}

// A caster close above the sheet casts a sharp shadow, whose penumbra is narrower.
TEST(ShadowClassifier, FewerTrianglesArePartialWhereTheShadowIsSharp) {
  const auto partial_among = [](const std::vector<KeyVisibility>& visibility) {
    return std::count(visibility.begin(), visibility.end(), KeyVisibility::partial);
  };
  TwoSheets close(100, 0.02F);
  TwoSheets apart(100, 0.3F);
  const auto sharp = partial_among(close.visibility());
  EXPECT_GT(sharp, 200);
  EXPECT_LT(sharp, 0.8 * static_cast<double>(partial_among(apart.visibility())));
}

// The whole shadow lies between the vertices, which therefore cannot see it.
TEST(ShadowClassifier, ACoarseMeshIsPartial) {
  TwoSheets scene(1);
  for (const KeyVisibility triangle : scene.visibility()) EXPECT_EQ(triangle, KeyVisibility::partial);
}

// The valley's sides rise above the plane of its bottom, but nothing is between them and the light.
TEST(ShadowClassifier, AValleyIsWhollyInTheLight) {
  TwoSheets scene(50);
  for (glm::vec3& p : scene.low.positions) p.y = 2.0F * p.x * p.x - 0.3F;
  for (glm::vec3& p : scene.high.positions) p += glm::vec3{2.0F, -0.3F, 0.0F};
  const Box box = unite(bounding_box(scene.low.positions), bounding_box(scene.high.positions));
  scene.block = make_frame_block(scene.frame, PictureSettings{}, box);
  for (const KeyVisibility triangle : scene.visibility()) EXPECT_EQ(triangle, KeyVisibility::lit);
}

TEST(ShadowClassifier, WithoutCastersEverythingIsInTheLight) {
  TwoSheets scene(4);
  ShadowClassifier classifier;
  const ShadowMap nothing;
  classifier.set_shadow_map(nothing, scene.block);
  std::vector<KeyVisibility> visibility;
  classifier.classify(scene.frame.surfaces[0], visibility);
  EXPECT_EQ(visibility.size(), 32U);
  for (const KeyVisibility triangle : visibility) EXPECT_EQ(triangle, KeyVisibility::lit);
}

TEST(ShadedFloor, HoldsTheShadowAndLittleElse) {
  TwoSheets scene(4);
  const std::array casters{&scene.frame.surfaces[0], &scene.frame.surfaces[1]};
  set_shadow_bounds(scene.block, casters);
  const PictureSettings settings;
  set_tile(scene.block, scene.frame.camera, settings, {0, 0, settings.width_px, settings.height_px});
  const PixelRect part = shaded_floor(scene.block);
  for (const float x : {-0.5F, 0.5F}) {
    for (const float z : {-0.5F, 0.5F}) {
      const glm::vec4 clip = scene.block.world_to_clip * glm::vec4{x, -0.2F, z, 1.0F};
      const glm::vec2 pixel = (0.5F + 0.5F * glm::vec2{clip} / clip.w) * glm::vec2{1280.0F, 720.0F};
      EXPECT_GT(pixel.x, static_cast<float>(part.x_px));
      EXPECT_LT(pixel.x, static_cast<float>(part.x_px + part.width_px));
      EXPECT_GT(pixel.y, static_cast<float>(part.y_px));
      EXPECT_LT(pixel.y, static_cast<float>(part.y_px + part.height_px));
    }
  }
  EXPECT_LT(part.width_px, 1000);
  EXPECT_LT(part.height_px, 600);
}

TEST(BandsAround, CoverEveryPixelButThePartsOnce) {
  for (const PixelRect& part : {PixelRect{}, PixelRect{3, 2, 4, 5}, PixelRect{0, 0, 12, 9}, PixelRect{5, 0, 7, 9}}) {
    std::array<int, 12 * 9> times{};
    const auto count = [&](const PixelRect& rect) {
      for (int y = rect.y_px; y < rect.y_px + rect.height_px; ++y) {
        for (int x = rect.x_px; x < rect.x_px + rect.width_px; ++x) {
          ++times[static_cast<std::size_t>(12 * y + x)];
        }
      }
    };
    count(part);
    for (const PixelRect& band : bands_around(part, {12, 9})) count(band);
    for (const int number : times) EXPECT_EQ(number, 1);
  }
}

}  // namespace
}  // namespace taut::renderer
