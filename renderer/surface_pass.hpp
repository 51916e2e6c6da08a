#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/colour_map_texture.hpp"
#include "renderer/covered_squares.hpp"
#include "renderer/frame_block.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/layer_target.hpp"
#include "renderer/lazy_program.hpp"
#include "renderer/studio_light.hpp"
#include "renderer/surface_tables.hpp"

namespace taut::renderer {

/// Surfaces in the studio's light: first which triangle is seen where, then the light of what is seen. The
/// block `Frame` and the light's textures have to be bound.
class SurfacePass {
 public:
  SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Hands the surfaces to the graphics card.
  void fill(std::span<const SurfaceView> surfaces, StudioLight& light);
  /// Draws those of the last fill() into the layer that is bound; `under_marks`: such as lie on them will
  /// follow.
  void draw_seen(bool under_marks);
  /// Lays what the layer has seen over the bound framebuffer, in which the layer's tile is `place`, as is the
  /// viewport. `block` is the tile's.
  void shade(const LayerTarget& layer, const FrameBlock& block, const PixelRect& place);

 private:
  void shade_squares(bool open, const LayerTarget& layer, const PixelRect& place);

  const GladGLContext* gl;
  LazyProgram seen;
  std::vector<LazyProgram> shading;  // by what defines() has
  ColourMapTexture colour_maps;
  SurfaceTables tables;
  CoveredSquares squares;
  VertexArray square_arrays;
  Buffer square_corners;
  SurfaceLight surface_light;  // scratch
  bool any_data = false;
};

}  // namespace taut::renderer
