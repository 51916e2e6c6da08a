#pragma once

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// The uniforms that all shaders share: the std140 block `Frame` of shaders/frame.glsl, which gives each
/// member's meaning and unit.
struct FrameBlock {
  glm::mat4 world_to_clip;
  glm::mat4 world_to_shadow;
  glm::vec4 eye;
  glm::vec4 towards_key;
  glm::vec4 towards_fill;
  glm::vec4 towards_rim;
  glm::vec4 upper_colour;
  glm::vec4 lower_colour;
  glm::vec4 ground;
  glm::vec4 viewport;
  glm::vec4 shadow;
  glm::vec4 shadow_blur;
  glm::vec4 shadow_bounds;
  glm::vec4 ground_light_area;
  glm::vec4 backdrop_horizon;
  glm::vec4 ray_corner;
  glm::vec4 ray_across;
  glm::vec4 ray_up;
};

/// A part of the picture that is drawn at once. Pixels of the finished picture, y from its top.
struct Tile {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// A rectangle of a framebuffer. Its pixels, y from the lower edge.
struct PixelRect {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// Returns the side of the shadow map in texels: settings.shadow_map_px, or less for a small picture, which
/// could not show the difference.
int shadow_map_side(const PictureSettings& settings);

/// Returns the block but for shadow_bounds and what depends on the tile. `casters`: the box around all shadow
/// casters, metres; none when there are none.
FrameBlock make_frame_block(const FrameView& frame, const PictureSettings& settings, const std::optional<Box>& casters);

/// Sets shadow_bounds to the bounds of the casters in the shadow map.
void set_shadow_bounds(FrameBlock& block, std::span<const SurfaceView* const> casters);

/// Sets world_to_clip, viewport and the rays for a tile.
void set_tile(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile);

/// Returns the matrix of an orthographic view of the sphere around the box, from world to 0..1 in all three
/// axes. `towards` is the unit direction to the viewer; depth (z) grows away from it.
glm::mat4 world_to_unit_cube(const Box& box, const glm::vec3& towards);

}  // namespace taut::renderer
