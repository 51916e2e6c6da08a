#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "scene_support.hpp"

namespace taut::renderer {
namespace {

using FrameCheckTest = SceneRendererTest;

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_F(FrameCheckTest, BadFramesAreRefusedByName) {
  constexpr std::array<std::uint32_t, 3> too_high{0, 1, 3};
  FrameView frame = triangle_frame();
  frame.surfaces.push_back(frame.surfaces[0]);
  frame.surfaces[1].triangles = too_high;
  const auto draw = [&] { renderer.draw(frame, small_picture()); };
  EXPECT_NE(refusal(draw).find("surface 1: index 3"), std::string::npos) << refusal(draw);

  frame = triangle_frame();
  auto positions = triangle_positions;
  positions[2].y = std::numeric_limits<float>::infinity();
  frame.surfaces[0].positions = positions;
  EXPECT_NE(refusal(draw).find("surface 0: position 2"), std::string::npos) << refusal(draw);

  frame = triangle_frame();
  frame.surfaces[0].normals = frame.surfaces[0].normals.first(2);
  EXPECT_NE(refusal(draw).find("2 normals, expected 3"), std::string::npos) << refusal(draw);

  frame = triangle_frame();
  const std::array<glm::vec3, 2> too_few{};
  frame.surfaces[0].material_coordinates = too_few;
  EXPECT_NE(refusal(draw).find("2 material coordinates, expected 3"), std::string::npos) << refusal(draw);
  auto unbounded = triangle_positions;
  unbounded[1].x = std::numeric_limits<float>::quiet_NaN();
  frame.surfaces[0].material_coordinates = unbounded;
  EXPECT_NE(refusal(draw).find("material coordinate 1"), std::string::npos) << refusal(draw);

  frame = triangle_frame();
  constexpr std::array<std::array<std::uint32_t, 2>, 1> parents{{{0, 2}}};
  constexpr std::array<std::uint32_t, 1> parent_triangles{0};
  frame.surfaces[0].refinement = Refinement{2, {}, parents, parent_triangles};
  EXPECT_NE(refusal(draw).find("index 2 in parents, there are 2"), std::string::npos) << refusal(draw);
  frame = triangle_frame();
  const TrimmedTriangle trim{.triangle = 1};
  frame.surfaces[0].trims = std::span(&trim, 1);
  EXPECT_NE(refusal(draw).find("index 1 in trims"), std::string::npos) << refusal(draw);

  PictureSettings settings = small_picture();
  settings.width_px = 0;
  const auto draw_nothing = [&] { renderer.draw(triangle_frame(), settings); };
  EXPECT_NE(refusal(draw_nothing).find("width_px is 0"), std::string::npos) << refusal(draw_nothing);
  settings = small_picture();
  settings.shading_px = 3;
  EXPECT_NE(refusal(draw_nothing).find("shading_px is 3"), std::string::npos) << refusal(draw_nothing);
  settings.shading_px = 1;
  settings.shadow_taps = 0;
  EXPECT_NE(refusal(draw_nothing).find("shadow_taps is 0"), std::string::npos) << refusal(draw_nothing);
}

}  // namespace
}  // namespace taut::renderer
