#pragma once

#include <string>
#include <vector>

#include "renderer/canvas.hpp"
#include "renderer/image.hpp"

namespace taut::app {

/// A picture in a figure, with its text below.
struct Panel {
  renderer::Image picture;
  std::string caption;   ///< behind the letter
  std::string measured;  ///< a second line, in grey; empty: none
};

/// How panels are set; the defaults suit 2400 to 3200 pixels printed 7 inches wide.
struct SheetStyle {
  std::size_t columns = 3;
  float border_px = 24.0F;
  float gap_px = 28.0F;
  float caption_px = 44.0F;   ///< size of the captions
  float measured_px = 36.0F;  ///< size of the second line
};

/// The panels in rows on white, lettered (a), (b), ... All pictures have to be of one size.
renderer::Image compose_sheet(const std::vector<Panel>& panels, const SheetStyle& style);

}  // namespace taut::app
