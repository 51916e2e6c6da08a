#pragma once

#include <optional>
#include <span>

#include "renderer/frame_block.hpp"
#include "renderer/gl_objects.hpp"
#include "renderer/lazy_program.hpp"

namespace taut::renderer {

/// Where things are drawn with more than one sample for each pixel of the picture, and how they get into it.
class LayerTarget {
 public:
  LayerTarget(const GladGLContext& context, std::span<const ShaderFile> files);

  /// As many samples as the context offers, up to the number asked for.
  int usable_samples(int wanted) const;
  /// Binds a target of the size given in drawn pixels and clears it: nothing drawn, alpha 0. Colours are
  /// sRGB-encoded, premultiplied with alpha in linear light.
  void begin(int width_px, int height_px, int samples);
  GLuint framebuffer() const { return drawn.name(); }
  /// Averages what was drawn in linear light and lays it over the tile's place in the picture, a framebuffer
  /// of `picture_height_px`.
  void resolve(GLuint picture, const Tile& tile, int picture_height_px, int supersampling);

  /// Largest side, in drawn pixels: memory for a large print stays bounded.
  static constexpr int max_side_px = 2048;

 private:
  void allocate(int width_px, int height_px, int samples);
  void copy_behind(GLuint picture, const Tile& tile, int bottom_px);

  const GladGLContext* gl;
  LazyProgram resolve_one;
  LazyProgram resolve_many;
  VertexArray no_arrays;
  std::optional<Texture> colour;
  std::optional<Renderbuffer> depth;
  Texture behind;  // the picture's tile, to be blended with
  Framebuffer drawn;
  int drawn_width_px = 0;
  int drawn_height_px = 0;
  int drawn_samples = 0;
  int most_samples = 1;
};

}  // namespace taut::renderer
