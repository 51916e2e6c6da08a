#pragma once

#include <glm/vec4.hpp>
#include <optional>

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// A visibility buffer (Burns and Hunt 2013): the number of the visible triangle and its depth, for each
/// sample of a tile. Surfaces are shaded from it afterwards. Also holds the colours of the marks, which share
/// its depth.
class VisibilityBuffer {
 public:
  /// The context must be current and outlive this object.
  explicit VisibilityBuffer(const GladGLContext& context);

  /// Clears the buffer at a size in drawn pixels and binds it for triangle numbers. More than one sample
  /// counts as four, or as one where the context has no four. Throws ContextError.
  void begin(int width_px, int height_px, int wanted_samples);
  /// Returns the samples per pixel: 1 or 4.
  int samples() const { return samples_; }
  /// Return the x and the y of the four samples in a pixel, 0 to 1 from its lower left corner.
  const glm::vec4& samples_x() const { return sample_places_x_; }
  const glm::vec4& samples_y() const { return sample_places_y_; }
  /// Binds the texture of triangle numbers to visibility_unit.
  void bind() const;

  /// Binds an empty colour buffer for marks, with the surfaces' depth. Its colours are sRGB-encoded and were
  /// premultiplied in linear light. Throws ContextError.
  void begin_marks();
  /// Returns the marks' colours; begin_marks() must have been called.
  const Texture& marks() const { return *marks_colour_; }

  /// Largest side, drawn pixels. Larger needs more memory, smaller cuts a large picture into more tiles.
  static constexpr int max_side_px = 2048;

 private:
  int usable_samples(int wanted) const;
  void allocate(int width_px, int height_px, int samples);
  void ask_sample_places();
  void allocate_texture(const Texture& texture, GLenum format) const;

  const GladGLContext* gl_;
  std::optional<Texture> triangle_ids_;
  std::optional<Renderbuffer> depth_;
  std::optional<Texture> marks_colour_;
  Framebuffer triangle_framebuffer_;
  Framebuffer marks_framebuffer_;
  int width_px_ = 0;
  int height_px_ = 0;
  int samples_ = 0;
  int most_samples_ = 1;
  glm::vec4 sample_places_x_{0.5F};
  glm::vec4 sample_places_y_{0.5F};
};

}  // namespace taut::renderer
