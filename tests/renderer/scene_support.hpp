#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

#include "renderer/scene_renderer.hpp"

namespace taut::renderer {

// Uniform ambient light alone: a surface whose normals point up shows its own colour.
inline Lighting flat_light() {
  Lighting lighting;
  lighting.key = lighting.fill = lighting.rim = 0.0F;
  lighting.ambient = 1.0F;
  return lighting;
}

// A camera that looks along -z at a region two metres high around the origin.
inline Camera front_camera() {
  Camera camera;
  camera.eye = {0.0F, 0.0F, 4.0F};
  camera.vertical_fov_rad = 2.0F * std::atan(0.25F);
  return camera;
}

// The arrays have to outlive the view.
inline SurfaceView make_surface(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                std::span<const std::uint32_t> triangles) {
  SurfaceView surface;
  surface.positions = positions;
  surface.normals = normals;
  surface.triangles = triangles;
  return surface;
}

inline constexpr std::array<glm::vec3, 3> triangle_positions{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
inline constexpr std::array<glm::vec3, 3> up_normals{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
inline constexpr std::array<std::uint32_t, 3> triangle_indices{0, 1, 2};

inline FrameView triangle_frame() {
  FrameView frame;
  SurfaceView surface = make_surface(triangle_positions, up_normals, triangle_indices);
  surface.style.outside_colour = rgb(0x2E8B57);
  surface.style.inside_colour = rgb(0xC05020);
  surface.style.sheen = 0.0F;
  surface.style.translucency = 0.0F;
  frame.surfaces.push_back(surface);
  frame.camera = front_camera();
  frame.lighting = flat_light();
  frame.backdrop.plain = true;
  frame.backdrop.lower_colour = rgb(0xFFFFFF);
  return frame;
}

inline PictureSettings small_picture() {
  PictureSettings settings;
  settings.width_px = 96;
  settings.height_px = 64;
  settings.shadow_map_px = 256;
  settings.sky_directions = 0;
  return settings;
}

// The sky's colour in shaders/cloth_light.glsl, a little cold.
inline constexpr glm::vec3 sky_colour{0.965F, 1.0F, 1.055F};

inline Colour lit_by(const glm::vec3& light, const Colour& colour) {
  Colour lit;
  for (int i = 0; i < 3; ++i) lit[i] = linear_to_srgb(light[i] * srgb_to_linear(colour[i]));
  return lit;
}

inline void expect_colour(const Image& image, int x, int y, Colour expected, float tolerance) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(image.at(x, y)[i], std::round(expected[i] * 255.0F), tolerance)
        << "channel " << i << " at " << x << "," << y;
  }
}

struct SceneRendererTest : testing::Test {
  std::unique_ptr<Context> context = create_context();
  SceneRenderer renderer{*context};
};

}  // namespace taut::renderer
