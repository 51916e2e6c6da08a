#pragma once

#include "app/drawing/drawing.hpp"

namespace taut::test {

/// Smallest readable text in print, in points of 1/72 inch.
inline constexpr float min_text_pt = 7.0F;

/// Returns the size of the smallest text of a drawing that is as wide as a page, in points.
inline float smallest_print_pt(const app::Drawing& drawing) {
  renderer::Canvas canvas(drawing.width_px, drawing.height_px, 0.02F);
  drawing.draw(canvas);
  return 72.0F * app::page_width_inches * canvas.min_text_px() / static_cast<float>(drawing.width_px);
}

}  // namespace taut::test
