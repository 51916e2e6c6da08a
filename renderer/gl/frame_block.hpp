#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "renderer/frame_view.hpp"

namespace taut::renderer {

/// What every shader of a frame shares: the std140 block `Frame` of shaders/frame.glsl, member by member.
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

/// A part of the picture that is drawn at once, in pixels of the finished picture; y counts from the top.
struct Tile {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// A rectangle of drawn pixels of a target, counted from its lower left corner.
struct PixelRect {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// Side of the shadow map: what the settings allow, or less where the picture is too small to show a
/// difference.
int shadow_map_side(const PictureSettings& settings);

/// `casters` is the box around everything that throws a shadow; none when nothing does. The block is complete
/// but for what depends on the tile.
FrameBlock make_frame_block(const FrameView& frame, const PictureSettings& settings,
                            const std::optional<Box>& casters);

/// Fills in where in the shadow map the casters are.
void set_shadow_bounds(FrameBlock& block, std::span<const SurfaceView* const> casters);

/// Fills in what depends on the tile.
void set_tile(FrameBlock& block, const Camera& camera, const PictureSettings& settings, const Tile& tile);

/// An orthographic view of the sphere around the box, from the given direction: world to 0..1 in all three
/// axes. Depth grows away from where `towards` points.
glm::mat4 world_to_unit_cube(const Box& box, const glm::vec3& towards);

}  // namespace taut::renderer
