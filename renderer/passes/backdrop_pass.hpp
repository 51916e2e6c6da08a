#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "renderer/gl/frame_block.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/gl/lazy_program.hpp"

namespace taut::renderer {

/// The part of the tile in which the key light's shadow may fall on the floor; the block has to be complete.
PixelRect shaded_floor(const FrameBlock& block);

/// What of a target of that size is left without the part: below, to its left and right, above.
std::array<PixelRect, 4> bands_around(const PixelRect& part, const glm::ivec2& size_px);

/// How closely what is behind is worked out, and blended between; fine costs more.
enum class BackdropGrid { fine, coarse, coarsest };

/// What is behind everything: the backdrop and the studio's floor.
class BackdropPass {
 public:
  BackdropPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Draws the tile the block is for into `framebuffer`, without looking at depth. `floor`: whether there is
  /// one to be seen. The block `Frame` and the light's textures have to be bound.
  void draw(GLuint framebuffer, const FrameBlock& block, bool floor, BackdropGrid fineness);

  /// Draws the floor's depth alone, so that it hides what is below it.
  void draw_floor_depth();

 private:
  // A texture that is drawn with larger pixels than the picture.
  struct CoarseMap {
    explicit CoarseMap(const GladGLContext& context);
    Texture texture;
    glm::ivec2 size_px{0};
  };
  void allocate(CoarseMap& map, const glm::ivec2& size_px, GLint format, GLenum attachment) const;
  void draw_grid(const Program& program, const FrameBlock& block, bool floor, BackdropGrid fineness) const;
  void draw_floor_shadow(const FrameBlock& block, const PixelRect& part);
  void draw_shaded(const FrameBlock& block, const PixelRect& part, BackdropGrid fineness);

  const GladGLContext* gl;
  LazyProgram lit;
  LazyProgram floor_shadow;
  LazyProgram shaded;
  LazyProgram floor_depth;
  CoarseMap shadow_map;
  Framebuffer shadow_framebuffer;
  VertexArray no_arrays;
};

}  // namespace taut::renderer
