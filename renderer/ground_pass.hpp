#pragma once

#include <span>

#include "renderer/frame_block.hpp"
#include "renderer/gl_objects.hpp"
#include "renderer/shader.hpp"

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

/// The studio's floor. Looking for shadows costs more than the rest of it, so that is done only where there
/// can be any.
class GroundPass {
 public:
  GroundPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Expects the depth test and the filled polygons' offset to be on; the block `Frame` and the light's
  /// textures have to be bound.
  void draw(const FrameBlock& block) const;

 private:
  void draw_part(const Program& program, const PixelRect& part) const;

  const GladGLContext* gl;
  Program open_floor;
  Program shaded_part;
  VertexArray no_arrays;
};

}  // namespace taut::renderer
