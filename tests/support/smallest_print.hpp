#pragma once

#include "app/drawing/drawing.hpp"

namespace taut::test {

/// The smallest text that can be read in print, in points of 1/72 inch.
inline constexpr float smallest_text_pt = 7.0F;

/// Size of the smallest text of a drawing as wide as a page, in points.
inline float smallest_print_pt(const app::Drawing& drawing) {
  renderer::Canvas canvas(drawing.width_px, drawing.height_px, 0.02F);
  drawing.draw(canvas);
  return 72.0F * app::page_width_inches * canvas.smallest_text_px() / static_cast<float>(drawing.width_px);
}

}  // namespace taut::test
