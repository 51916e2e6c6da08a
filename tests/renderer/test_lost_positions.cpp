#include <algorithm>
#include <functional>
#include <limits>

#include "renderer/frame_view.hpp"
#include "renderer/passes/backdrop_pass.hpp"
#include "renderer/passes/mark_pass.hpp"
#include "renderer/passes/surface_pass.hpp"
#include "scene_support.hpp"

// Cloth that flew apart: every part of the renderer that reads positions is given some that are far away or not finite.
// The picture may show nothing, but no array is read or written out of range.

namespace taut::renderer {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float largest = std::numeric_limits<float>::max();

// Two triangles whose first `lost` vertices are at a place where a runaway cloth may be.
struct Runaway {
  std::vector<glm::vec3> positions{{-0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, -0.5F}};
  std::vector<glm::vec3> normals = std::vector<glm::vec3>(4, {0, 1, 0});
  std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};

  Runaway(const glm::vec3& place, std::size_t lost) {
    // The vertices are at different places, as triangles would have no area otherwise.
    const std::array turns{glm::vec3{1, 1, 1}, glm::vec3{-1, 1, 1}, glm::vec3{1, -1, 0.5F}, glm::vec3{0.5F, 1, -1}};
    for (std::size_t i = 0; i < lost; ++i) positions[i] = place * turns[i];
  }
  SurfaceView view() const { return make_surface(positions, normals, triangles); }
};

void for_each_runaway(const std::function<void(const Runaway&)>& look) {
  for (const float far : {1e5F, 1e9F, 3e9F, 1e12F, 1e19F, 1e30F, largest, inf, nan}) {
    for (const glm::vec3& place : {glm::vec3{far, far, far}, glm::vec3{far, 0.3F, 0.2F}, glm::vec3{0.1F, -far, 0.2F},
                                   glm::vec3{0.1F, 0.3F, far}}) {
      for (const std::size_t lost : {1U, 2U, 4U}) look(Runaway(place, lost));
    }
  }
}

TEST(LostPositions, TheShadedFloorStaysInTheTile) {
  for_each_runaway([](const Runaway& cloth) {
    const std::array casters{cloth.view()};
    FrameView frame;
    frame.ground_height_m = cloth.positions[0].y;
    for (const Box& box : {bounding_box(cloth.positions), Box{glm::vec3{-1.0F}, glm::vec3{1.0F}}}) {
      FrameBlock block = make_frame_block(frame, PictureSettings{}, box);
      set_shadow_bounds(block, casters);
      set_tile(block, frame.camera, PictureSettings{}, {0, 0, 1280, 720});
      const PixelRect floor = shaded_floor(block);
      EXPECT_TRUE(floor.x_px >= 0 && floor.width_px >= 0 && floor.x_px + floor.width_px <= 1280);
      EXPECT_TRUE(floor.y_px >= 0 && floor.height_px >= 0 && floor.y_px + floor.height_px <= 720);
    }
  });
}

TEST(LostPositions, ScreenBoundsStayInThePicture) {
  const Camera camera = front_camera();
  const glm::mat4 to_clip = camera.projection(1.5F) * camera.view();
  for_each_runaway([&](const Runaway& cloth) {
    FrameView frame;
    frame.lines.push_back({.points = cloth.positions});
    frame.points.push_back({.centres = cloth.positions});
    const std::array surfaces{cloth.view()};
    const Tile area = screen_bounds(frame, surfaces, to_clip, small_picture());
    EXPECT_TRUE(area.x_px >= 0 && area.width_px >= 0 && area.x_px + area.width_px <= 96);
    EXPECT_TRUE(area.y_px >= 0 && area.height_px >= 0 && area.y_px + area.height_px <= 64);
    static_cast<void>(reaches_below(0.0F, frame, surfaces));
  });
}

TEST(LostPositions, NormalsStayOfUnitLength) {
  for_each_runaway([](const Runaway& cloth) {
    std::vector<glm::vec3> normals(cloth.positions.size());
    vertex_normals(cloth.positions, cloth.triangles, normals);
    for (const glm::vec3& normal : normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-4F);
  });
}

TEST(LostPositions, ACameraFitsOrTheBoxIsRefused) {
  for_each_runaway([](const Runaway& cloth) {
    const Box box = bounding_box(cloth.positions);
    const auto see = [&](const std::function<Camera()>& framed) {
      try {
        const Camera camera = framed();
        EXPECT_TRUE(std::isfinite(glm::length(camera.eye)) && std::isfinite(camera.far_m));
      } catch (const std::invalid_argument&) {
        EXPECT_FALSE(is_near(box));
      }
    };
    see([&] { return fit_camera_to_box(box, {}, 1.5F); });
    see([&] { return fit_camera_to_points(cloth.positions, {}, 1.5F); });
  });
}

using LostPicturesTest = SceneRendererTest;

// Whole pictures with everything that a picture may contain. A position that is not finite is refused by name; a far
// one is drawn, and things near the camera stay visible.
TEST_F(LostPicturesTest, AreDrawnOrRefused) {
  for (const float far : {1e5F, 1e9F, 1e12F, 1e30F, largest, inf, nan}) {
    const Runaway cloth({far, -far, far}, 2);
    FrameView frame = triangle_frame();
    frame.backdrop.plain = false;
    frame.ground_height_m = -1.2F;
    frame.surfaces.push_back(cloth.view());
    constexpr std::array<std::array<std::uint32_t, 2>, 2> edges{{{0, 1}, {2, 3}}};
    frame.surfaces.back().wireframe = Wireframe{.edges = edges};
    frame.spheres.push_back({.centres = cloth.positions});
    const Colour colour = rgb(0x1A1A1A);
    frame.lines.push_back({.points = cloth.positions, .colour = colour});
    frame.points.push_back({.centres = cloth.positions, .colour = colour});
    PictureSettings settings = small_picture();
    settings.sky_directions = 6;
    for (const int samples : {1, 4}) {
      settings.samples = samples;
      if (std::isfinite(far)) {
        const Image image = renderer.draw(frame, settings);
        EXPECT_EQ(image.width_px, 96);
      } else {
        EXPECT_THROW(renderer.draw(frame, settings), std::invalid_argument);
      }
    }
  }
}

TEST_F(LostPicturesTest, ACameraThatIsTooFarIsRefused) {
  for (const float far : {1e10F, 1e30F, inf, nan}) {
    FrameView frame = triangle_frame();
    frame.camera.eye.x = far;
    EXPECT_THROW(renderer.draw(frame, small_picture()), std::invalid_argument);
    frame = triangle_frame();
    frame.camera.target = glm::vec3{far};
    EXPECT_THROW(renderer.draw(frame, small_picture()), std::invalid_argument);
  }
}

}  // namespace
}  // namespace taut::renderer
