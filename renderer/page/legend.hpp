#pragma once

#include <optional>
#include <string>

#include "renderer/page/canvas.hpp"
#include "renderer/page/colour.hpp"

namespace taut::renderer {

/// A colour bar that says what the colours of a ScalarColours mean.
struct Legend {
  std::string title;  ///< e.g. "stretch"
  float minimum = 0.0F;
  float maximum = 1.0F;
  ColourMap map = ColourMap::viridis;
  float factor = 1.0F;  ///< numbers are printed times this: 100 with suffix " %" for fractions
  std::string suffix;
  std::optional<float> bound;         ///< a value to mark on the bar, in the unit of minimum and maximum
  std::string bound_label = "bound";  ///< printed next to the mark
  bool more_above = false;            ///< an arrow head: values above maximum exist and take its colour
};

struct LegendPlace {
  float x_px = 24.0F;  ///< of the bar's upper left corner; the title is above, the numbers are to the right
  float y_px = 48.0F;
  float bar_width_px = 16.0F;
  float bar_height_px = 240.0F;
  TextStyle text;
};

/// A vertical bar with ticks at round numbers.
void draw_legend(Canvas& canvas, const Legend& legend, const LegendPlace& place = {});

}  // namespace taut::renderer
