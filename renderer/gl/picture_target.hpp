#pragma once

#include <optional>

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// A picture: one sample a pixel, sRGB-encoded bytes. Eight bits are enough because the encoding spends them
/// where the eye does.
class PictureTarget {
 public:
  /// The context must be current and outlive this object. GL_SRGB8_ALPHA8: OpenGL encodes while
  /// GL_FRAMEBUFFER_SRGB is enabled. GL_RGBA8: what is drawn is encoded already.
  explicit PictureTarget(const GladGLContext& context, GLenum stored_as = GL_SRGB8_ALPHA8);

  /// Binds the framebuffer at a size in pixels. Its contents are undefined. Throws ContextError.
  void begin(int width_px, int height_px);
  /// Makes the bound picture transparent.
  void clear() const;
  /// Binds the framebuffer at its present size.
  void bind() const;
  /// Returns the framebuffer's name.
  GLuint framebuffer() const { return finished_.name(); }
  /// Returns the picture's texture; begin() must have been called.
  const Texture& texture() const { return *colour_; }
  /// Returns the picture as RGB, top row first.
  Image read() const;
  /// Returns the picture as RGBA. Its colours, which are premultiplied in linear light, are divided by alpha.
  Image read_with_alpha() const;
  /// Copies the picture, stretched to width_px by height_px, to the bottom of a framebuffer, left_px from its
  /// left side.
  void show(GLuint target, int width_px, int height_px, int left_px) const;

 private:
  void allocate(int width_px, int height_px);

  const GladGLContext* gl_;
  GLenum format_;
  std::optional<Texture> colour_;
  Framebuffer finished_;
  int width_px_ = 0;
  int height_px_ = 0;
};

/// Returns the lower left width_px by height_px of a framebuffer as RGB, top row first. The context must be
/// current.
Image read_framebuffer(const GladGLContext& gl, GLuint framebuffer, int width_px, int height_px);

}  // namespace taut::renderer
