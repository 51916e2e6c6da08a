#pragma once

#include <glm/vec4.hpp>
#include <optional>

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// Where things are drawn before they get into the picture: which triangle each sample sees, how far away it
/// is, and the marks in front.
class LayerTarget {
 public:
  explicit LayerTarget(const GladGLContext& context);

  /// Makes room for a size in drawn pixels, clears it and binds what holds the triangles. More than one
  /// sample means four, where the context offers as many.
  void begin(int width_px, int height_px, int wanted_samples);
  int samples() const { return layer_samples; }
  /// Where in a pixel four samples are, 0 to 1 from its lower left corner.
  const glm::vec4& samples_x() const { return sample_places_x; }
  const glm::vec4& samples_y() const { return sample_places_y; }
  /// Binds the texture of what was seen.
  void bind_seen() const;

  /// Binds a target for marks, with nothing in it but the depth of what was drawn. Colours are sRGB-encoded,
  /// premultiplied with alpha in linear light.
  void begin_marks();
  const Texture& marks() const { return *marks_colour; }

  /// Largest side, in drawn pixels: memory for a large print stays bounded.
  static constexpr int max_side_px = 2048;

 private:
  int usable_samples(int wanted) const;
  void allocate(int width_px, int height_px, int samples);
  void ask_sample_places();
  void allocate_texture(const Texture& texture, GLenum format) const;

  const GladGLContext* gl;
  std::optional<Texture> seen;
  std::optional<Renderbuffer> depth;
  std::optional<Texture> marks_colour;
  Framebuffer seen_framebuffer;
  Framebuffer marks_framebuffer;
  int layer_width_px = 0;
  int layer_height_px = 0;
  int layer_samples = 0;
  int most_samples = 1;
  glm::vec4 sample_places_x{0.5F};
  glm::vec4 sample_places_y{0.5F};
};

}  // namespace taut::renderer
