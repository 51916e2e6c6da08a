#pragma once

#include "renderer/frame_block.hpp"
#include "renderer/gl_objects.hpp"
#include "renderer/lazy_program.hpp"

namespace taut::renderer {

/// A rectangle of drawn pixels of the tile, counted from its lower left corner.
struct PixelRect {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
};

/// The part of the tile in which the key light's shadow may fall on the floor; the block has to be complete.
PixelRect shaded_floor(const FrameBlock& block);

/// What is behind everything: the backdrop and the studio's floor.
class BackdropPass {
 public:
  BackdropPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Draws the tile the block is for into `framebuffer`, without looking at depth. `floor`: whether there is
  /// one to be seen. The block `Frame` and the light's textures have to be bound.
  void draw(GLuint framebuffer, const FrameBlock& block, const glm::mat4& clip_to_direction, bool floor);

  /// Draws the floor's depth alone, so that it hides what is below it.
  void draw_floor_depth();

 private:
  void draw_map(const FrameBlock& block, const glm::mat4& clip_to_direction, bool floor);
  void draw_shaded_floor(const FrameBlock& block);

  const GladGLContext* gl;
  LazyProgram coarse;
  LazyProgram stretched;
  LazyProgram shaded_part;
  LazyProgram floor_depth;
  Texture map;
  Framebuffer map_framebuffer;
  VertexArray no_arrays;
  glm::ivec2 map_px{0};
};

}  // namespace taut::renderer
