#pragma once

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/png.hpp"

namespace taut::renderer {

/// Visibility buffer (Burns and Hunt 2013): number and depth of the visible triangle for each sample of a tile.
/// Surfaces are shaded from it afterwards. It also holds the colours of the marks, which share its depth.
class VisibilityBuffer {
 public:
  /// The context must be current and outlive this object.
  explicit VisibilityBuffer(const GladGLContext& context);

  /// Clears the buffer at a size in drawn pixels and binds it for triangle numbers. More than one sample counts as
  /// four, or as one if the context has no four. Throws ContextError.
  void begin(int width_px, int height_px, int wanted_samples);
  /// Returns the number of samples per pixel: 1 or 4.
  int samples() const { return samples_; }
  /// Return the x and the y of the four samples in a pixel, 0 to 1 from its lower left corner.
  const glm::vec4& samples_x() const { return sample_places_x_; }
  const glm::vec4& samples_y() const { return sample_places_y_; }
  /// Binds the texture of triangle numbers to visibility_unit.
  void bind() const { bind_texture(*gl_, visibility_unit, target(), *triangle_ids_); }

  /// Binds an empty colour buffer for marks, with the surfaces' depth. Its colours are sRGB-encoded and premultiplied
  /// in linear light. Throws ContextError.
  void begin_marks();
  /// Returns the marks' colours; begin_marks() must have been called.
  const Texture& marks() const { return *marks_colour_; }

  /// Largest side, drawn pixels. Higher values need more memory, lower ones cut a large picture into more tiles.
  static constexpr int max_side_px = 2048;

 private:
  void allocate(int width_px, int height_px, int samples);
  void allocate_texture(const Texture& texture, GLenum format) const;
  void attach(const Texture& texture, const char* name) const;
  GLenum target() const { return samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D; }

  const GladGLContext* gl_;
  std::optional<Texture> triangle_ids_;
  std::optional<Renderbuffer> depth_;
  std::optional<Texture> marks_colour_;
  Framebuffer triangle_framebuffer_;
  Framebuffer marks_framebuffer_;
  int width_px_ = 0;
  int height_px_ = 0;
  int samples_ = 0;
  int max_samples_ = 1;
  glm::vec4 sample_places_x_{0.5F};
  glm::vec4 sample_places_y_{0.5F};
};

/// Picture with one sample per pixel, as sRGB-encoded bytes. Eight bits suffice because the encoding spends them where
/// the eye does.
class PictureTarget {
 public:
  /// The context must be current and outlive this object. `stored_as`: with GL_SRGB8_ALPHA8 OpenGL encodes while
  /// GL_FRAMEBUFFER_SRGB is enabled; with GL_RGBA8 colours must be encoded already.
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
  /// Returns the picture as RGB, top row first, or as RGBA with colours divided by alpha; the stored ones are
  /// premultiplied in linear light.
  Image read(bool has_alpha) const;
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

/// Render texture whose size only grows, as it changes with every step of a garment.
class GrowingTarget {
 public:
  /// The context must be current and outlive this object. The texture is bound to `texture_unit`.
  GrowingTarget(const GladGLContext& context, GLint stored_as, unsigned texture_unit)
      : gl_(&context), format_(stored_as), unit_(texture_unit), texture_(context), framebuffer_(context) {}
  /// Binds the framebuffer and sets the viewport to its lower left size_px. Throws ContextError.
  void begin(const glm::ivec2& size_px);
  /// Binds the texture to its unit.
  void bind() const { bind_texture(*gl_, unit_, GL_TEXTURE_2D, texture_); }
  /// Returns the size of the texture.
  const glm::ivec2& size_px() const { return size_px_; }

 private:
  const GladGLContext* gl_;
  GLint format_;
  unsigned unit_;
  Texture texture_;
  Framebuffer framebuffer_;
  glm::ivec2 size_px_{0};
};

/// Framebuffer object of sRGB-encoded colours in a plain RGBA8 texture, for SceneRenderer::draw_to.
class ColourTarget {
 public:
  /// Makes the context current. The context must outlive the target. Throws ContextError.
  explicit ColourTarget(Context& context);
  ~ColourTarget();

  /// Returns the framebuffer's name. Its texture is reallocated when the size differs. Throws ContextError.
  unsigned framebuffer(int width_px, int height_px);

  /// Copies a rectangle to the same place of another framebuffer (0: the window). (x_px, y_px) is the lower left corner
  /// of the rectangle, relative to the picture's. Throws ContextError.
  void copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const;

 private:
  Context& context_;
  std::unique_ptr<PictureTarget> picture_;
};

/// Returns the lower left width_px by height_px of a framebuffer (0: the window) as RGB, top row first.
/// Throws ContextError.
Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px);

/// Fills a framebuffer with grey, 0 black to 1 white.
void clear_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px, float grey);

/// Waits until all drawing commands have been executed (glFinish), e.g. before a clock is read.
void finish_drawing(Context& context);

}  // namespace taut::renderer
