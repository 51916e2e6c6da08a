#pragma once

#include <memory>

#include "renderer/context/context.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// A framebuffer object of finished, encoded colours: for SceneRenderer::draw_to where the window is not the
/// target.
class ColourTarget {
 public:
  /// The context has to outlive the target.
  explicit ColourTarget(Context& context);
  ~ColourTarget();
  ColourTarget(const ColourTarget&) = delete;
  ColourTarget& operator=(const ColourTarget&) = delete;

  /// The framebuffer's name, with room for this size. Throws ContextError.
  unsigned framebuffer(int width_px, int height_px);

  /// Copies a part of what was drawn to the same place of another framebuffer (0: the window); `x_px` and
  /// `y_px` are its lower left corner, from that of the picture.
  void copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts;
};

/// The lower left part of a framebuffer (0: the window), as RGB.
Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px);

/// Fills a framebuffer with grey. 0 is black, 1 white.
void clear_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px, float grey);

/// Waits until everything asked for is drawn, so that a clock tells the truth.
void finish_drawing(Context& context);

}  // namespace taut::renderer
