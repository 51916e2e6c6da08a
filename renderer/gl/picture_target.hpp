#pragma once

#include <optional>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// A picture: one sample a pixel, sRGB-encoded bytes. Eight bits are enough because the encoding spends them
/// where the eye does.
class PictureTarget {
 public:
  /// GL_SRGB8_ALPHA8: OpenGL encodes where it is told to; GL_RGBA8: what is drawn is encoded already.
  explicit PictureTarget(const GladGLContext& context, GLenum stored_as = GL_SRGB8_ALPHA8);

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
  GLenum format;
  std::optional<Texture> colour;
  Framebuffer finished;
  int picture_width_px = 0;
  int picture_height_px = 0;
};

/// The lower left part of a framebuffer, top row first, as RGB.
Image read_framebuffer(const GladGLContext& gl, GLuint framebuffer, int width_px, int height_px);

}  // namespace taut::renderer
