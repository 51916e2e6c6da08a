#pragma once

#include "renderer/gl/picture_target.hpp"

namespace taut::renderer {

/// Returns the part of the tile in which the key light's shadow may fall on the floor, in drawn pixels. The block must
/// be complete.
PixelRect shaded_floor(const FrameBlock& block);

/// Size of the grid at whose vertices the background is shaded. Fine costs more.
enum class BackdropGrid { fine, coarse, coarsest };

/// Draws the backdrop and the floor with its shadow.
class BackdropPass {
 public:
  /// The context must be current and outlive this object.
  explicit BackdropPass(const GladGLContext& context);

  /// Draws the block's tile to the lower left corner of a framebuffer, without the depth test. `floor`: the floor is
  /// visible. The block `Frame` and the light's textures must be bound.
  void draw(GLuint framebuffer, const FrameBlock& block, bool floor, BackdropGrid fineness);

  /// Draws only the floor's depth, so that it hides everything below. The block `Frame` must be bound.
  void draw_floor_depth();

 private:
  void draw_grid(const Program& program, const FrameBlock& block, bool floor, BackdropGrid fineness) const;
  void draw_floor_shadow(const FrameBlock& block, const PixelRect& part);
  void draw_shaded(const FrameBlock& block, const PixelRect& part, BackdropGrid fineness);

  const GladGLContext* gl_;
  LazyProgram lit_;
  LazyProgram floor_shadow_;
  LazyProgram shaded_;
  LazyProgram floor_depth_;
  GrowingTarget floor_shadow_map_;  // has larger pixels than the picture
  VertexArray no_arrays_;
};

}  // namespace taut::renderer
