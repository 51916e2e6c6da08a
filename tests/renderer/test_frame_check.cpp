#include <limits>
#include <stdexcept>

#include "renderer/frame_view.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

using FrameCheckTest = SceneRendererTest;

TEST_F(FrameCheckTest, UnsoundFramesAreRefused) {
  EXPECT_TRUE(is_sound(triangle_frame()));
  constexpr std::array<std::uint32_t, 3> too_high{0, 1, 3};
  FrameView frame = triangle_frame();
  frame.surfaces.push_back(frame.surfaces[0]);
  frame.surfaces[1].triangles = too_high;
  EXPECT_FALSE(is_sound(frame));
  EXPECT_THROW(renderer.draw(frame, small_picture()), std::invalid_argument);

  frame = triangle_frame();
  auto positions = triangle_positions;
  positions[2].y = std::numeric_limits<float>::infinity();
  frame.surfaces[0].positions = positions;
  EXPECT_FALSE(is_sound(frame));

  frame = triangle_frame();
  frame.surfaces[0].normals = frame.surfaces[0].normals.first(2);
  EXPECT_FALSE(is_sound(frame));

  frame = triangle_frame();
  const std::array<glm::vec3, 2> too_few{};
  frame.surfaces[0].material_coordinates = too_few;
  EXPECT_FALSE(is_sound(frame));
  auto unbounded = triangle_positions;
  unbounded[1].x = std::numeric_limits<float>::quiet_NaN();
  frame.surfaces[0].material_coordinates = unbounded;
  EXPECT_FALSE(is_sound(frame));

  frame = triangle_frame();
  constexpr std::array<std::array<std::uint32_t, 2>, 1> parents{{{0, 2}}};
  constexpr std::array<std::uint32_t, 1> parent_triangles{0};
  frame.surfaces[0].refinement = Refinement{2, {}, parents, parent_triangles};
  EXPECT_FALSE(is_sound(frame));
  frame = triangle_frame();
  const TrimmedTriangle trim{.triangle = 1};
  frame.surfaces[0].trims = std::span(&trim, 1);
  EXPECT_FALSE(is_sound(frame));
}

TEST_F(FrameCheckTest, SettingsOutOfRangeAreRefused) {
  EXPECT_TRUE(is_sound(small_picture()));
  for (const auto setting :
       {&PictureSettings::width_px, &PictureSettings::shading_px, &PictureSettings::shadow_taps}) {
    PictureSettings settings = small_picture();
    settings.*setting = setting == &PictureSettings::shading_px ? 3 : 0;
    EXPECT_FALSE(is_sound(settings));
    EXPECT_THROW(renderer.draw(triangle_frame(), settings), std::invalid_argument);
  }
}

}  // namespace
}  // namespace taut::renderer
