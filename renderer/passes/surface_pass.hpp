#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "renderer/frame_view.hpp"
#include "renderer/gl/colour_map_texture.hpp"
#include "renderer/gl/frame_block.hpp"
#include "renderer/gl/layer_target.hpp"
#include "renderer/gl/lazy_program.hpp"
#include "renderer/light/studio_light.hpp"
#include "renderer/light/surface_tables.hpp"
#include "renderer/passes/covered_squares.hpp"

namespace taut::renderer {

/// Surfaces in the studio's light: first which triangle is seen where, then the light of what is seen. The
/// block `Frame` and the light's textures have to be bound.
class SurfacePass {
 public:
  SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Hands over where the surfaces are, which is all that draw_seen() needs.
  void place(std::span<const SurfaceView> surfaces);
  /// Draws those into the layer that is bound; `under_marks`: such as lie on them will follow.
  void draw_seen(bool under_marks);
  /// Collects the light that arrives at the same surfaces. Needs no context: another thread may do it while
  /// they are drawn.
  void gather(std::span<const SurfaceView> surfaces, StudioLight& light);
  /// Hands over what was gathered.
  void upload();
  /// Binds the framebuffer and lays what the layer has seen over it. The layer's tile is `place` there, and
  /// the viewport; `block` is the tile's. `halve`: with one sample, two by two pixels of an even tile are
  /// shaded as one.
  void shade(const LayerTarget& layer, GLuint framebuffer, const FrameBlock& block, const PixelRect& place,
             bool halve);

 private:
  void draw_squares(bool open);
  void shade_squares(std::size_t kind, const LayerTarget& layer, const glm::ivec2& corner_px);
  void begin_halved(const glm::ivec2& size_px);
  void shade_halved(const LayerTarget& layer, GLuint framebuffer, const PixelRect& place);

  const GladGLContext* gl;
  LazyProgram seen;
  VertexArray placed_arrays;
  Buffer placed_positions;
  std::vector<glm::vec3> placed;  // three for each triangle
  std::vector<std::vector<std::string_view>> variant_defines;
  std::vector<LazyProgram> shading;  // by what defines() has
  ColourMapTexture colour_maps;
  SurfaceTables tables;
  CoveredSquares squares;
  VertexArray square_arrays;
  Buffer square_corners;
  LazyProgram stretching;
  Texture halved_colour;
  Framebuffer halved_framebuffer;
  glm::ivec2 halved_px{0};
  SurfaceLight surface_light;  // scratch
  bool any_data = false;
};

}  // namespace taut::renderer
