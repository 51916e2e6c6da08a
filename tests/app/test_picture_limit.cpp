// Changes that an eye hardly sees and a picture test must detect. No scene can ask for these;
// tests/golden/CMakeLists.txt has the changes that a scene can ask for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "app/drawing/drawing.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/models/garment_loading.hpp"
#include "support/picture_difference.hpp"

namespace taut::app {
namespace {

// Rotates by one degree around x.
glm::vec3 turn(const glm::vec3& v) {
  constexpr float turn_rad = std::numbers::pi_v<float> / 180.0F;
  const float c = std::cos(turn_rad), s = std::sin(turn_rad);
  return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
}

class PictureLimit : public testing::Test {
 protected:
  PictureLimit() : scene(read_scene_file(TAUT_TESTS_FOLDER "/golden/scenes/tshirt_hung.toml")) {
    scene.picture.settings.width_px = scene.picture.settings.height_px = 360;
    const LoadedGarment loaded = load_garment(scene, [](const std::string&) {});
    const sim::Garment garment = make_simulation(scene, loaded).garment();
    painter.emplace(offscreen.renderer(), scene, garment, std::vector<sim::Body>(), std::span<const sim::Index>());
    frame = painter->view(garment.mesh.positions, 0.0);
    expected = drawn(frame);
  }
  renderer::Image drawn(const renderer::FrameView& view) {
    return offscreen.renderer().draw(view, to_picture_settings(scene.picture));
  }
  bool is_seen(const renderer::FrameView& changed) {
    const tests::PictureLimit limit;
    return !passes(compare(expected, drawn(changed), limit), limit);
  }

  DrawnScene scene;
  OffscreenRenderer offscreen{"auto"};
  std::optional<GarmentPainter> painter;
  renderer::FrameView frame;
  renderer::Image expected;
};

TEST_F(PictureLimit, PassesTheSamePicture) { EXPECT_FALSE(is_seen(frame)); }

TEST_F(PictureLimit, TellsNormalsTurnedByADegree) {
  const std::span<const glm::vec3> before = frame.surfaces.back().normals;
  std::vector<glm::vec3> normals(before.size());
  std::transform(before.begin(), before.end(), normals.begin(), turn);
  frame.surfaces.back().normals = normals;
  EXPECT_TRUE(is_seen(frame));
}

TEST_F(PictureLimit, TellsALightTurnedByADegree) {
  frame.lighting.towards_key = turn(frame.lighting.towards_key);
  EXPECT_TRUE(is_seen(frame));
}

}  // namespace
}  // namespace taut::app
