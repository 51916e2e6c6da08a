#pragma once

#include "renderer/gl/picture_target.hpp"

namespace taut::renderer {

/// Sums of all passes in linear light, and the finished picture made of them.
class SamplingPass {
 public:
  /// The context must be current and outlive this object.
  explicit SamplingPass(const GladGLContext& context);
  /// Clears the sums at a size in pixels.
  void begin(int width_px, int height_px);
  /// Sets what is behind everything in all passes: a colour in linear light, premultiplied.
  void set_behind(const glm::vec4& colour, int passes) const;
  /// Adds the backdrop and floor of a pass. The block `Frame` and the light maps must be bound.
  void add_backdrop();
  /// Writes the mean of the passes to a rectangle of a framebuffer. `data_colours`: tones keep their hue.
  void develop(GLuint framebuffer, const PixelRect& place, int passes, bool data_colours);

  GLuint surfaces() const { return surfaces_.framebuffer(); }
  GLuint marks() const { return marks_.framebuffer(); }

 private:
  const GladGLContext* gl_;
  PictureTarget surfaces_;
  PictureTarget behind_;  // half as wide and high
  PictureTarget marks_;
  LazyProgram backdrop_;
  LazyProgram film_;
  VertexArray no_arrays_;
};

}  // namespace taut::renderer
