#pragma once

#include <memory>

#include "renderer/context/context.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// A framebuffer object of sRGB-encoded colours in a plain RGBA8 texture, to be drawn to by
/// SceneRenderer::draw_to.
class ColourTarget {
 public:
  /// Makes the context current. The context must outlive the target. Throws ContextError.
  explicit ColourTarget(Context& context);
  ~ColourTarget();
  ColourTarget(const ColourTarget&) = delete;
  ColourTarget& operator=(const ColourTarget&) = delete;

  /// Returns the framebuffer's name. Its texture is reallocated when the size differs. Throws ContextError.
  unsigned framebuffer(int width_px, int height_px);

  /// Copies a rectangle to the same place of another framebuffer (0: the window). (x_px, y_px) is the lower
  /// left corner of the rectangle, counted from that of the picture. Throws ContextError.
  void copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns the lower left width_px by height_px of a framebuffer (0: the window) as RGB, top row first.
/// Throws ContextError.
Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px);

/// Fills a framebuffer with grey, 0 black to 1 white.
void clear_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px, float grey);

/// Waits until all drawing commands have been executed (glFinish), e.g. before a clock is read.
void finish_drawing(Context& context);

}  // namespace taut::renderer
