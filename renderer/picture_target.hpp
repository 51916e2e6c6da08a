#pragma once

#include <optional>
#include <span>

#include "renderer/frame_block.hpp"
#include "renderer/gl_objects.hpp"
#include "renderer/image.hpp"
#include "renderer/shader.hpp"

namespace taut::renderer {

/// Where tiles are drawn, and how they become the finished picture.
class PictureTarget {
 public:
  PictureTarget(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Binds a target of the size given in drawn pixels, with as many samples as the context offers up to the
  /// number asked for, and clears its depth. What is drawn is linear light.
  void begin(int width_px, int height_px, int samples);
  /// Averages what was drawn into the tile's place in `framebuffer`, whose height is needed to count from its
  /// bottom; `top_first` stores the top row first.
  void resolve(GLuint framebuffer, const Tile& tile, int picture_height_px, int supersampling,
               bool top_first);

  /// A framebuffer for resolve() that read() reads.
  GLuint picture_framebuffer(int width_px, int height_px);
  Image read(int width_px, int height_px) const;

  /// Largest side of a tile, in drawn pixels: memory for a large print stays bounded.
  static constexpr int max_side_px = 2048;

 private:
  void allocate(int width_px, int height_px, int samples);

  const GladGLContext* gl;
  Program resolve_one;
  Program resolve_many;
  VertexArray no_arrays;
  std::optional<Texture> colour;
  std::optional<Renderbuffer> depth;
  Framebuffer drawn;
  std::optional<Texture> picture;
  Framebuffer finished;
  int drawn_width_px = 0;
  int drawn_height_px = 0;
  int drawn_samples = 0;
  int picture_width_px = 0;
  int picture_height_px = 0;
  int most_samples = 1;
};

}  // namespace taut::renderer
