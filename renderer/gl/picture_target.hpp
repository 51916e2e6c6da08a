#pragma once

#include <optional>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// A picture: one sample a pixel, sRGB-encoded bytes.
class PictureTarget {
 public:
  explicit PictureTarget(const GladGLContext& context);

  /// Binds it at the size given; what was in it stays undefined until it is drawn.
  void begin(int width_px, int height_px);
  void bind() const;
  GLuint framebuffer() const { return finished.name(); }
  const Texture& texture() const { return *colour; }
  /// The picture, top row first.
  Image read() const;
  /// Copies the picture, stretched to this size, to the lower left part of a framebuffer.
  void show(GLuint target, int width_px, int height_px) const;

 private:
  void allocate(int width_px, int height_px);

  const GladGLContext* gl;
  std::optional<Texture> colour;
  Framebuffer finished;
  int picture_width_px = 0;
  int picture_height_px = 0;
};

}  // namespace taut::renderer
