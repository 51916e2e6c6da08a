#pragma once

#include "renderer/page/canvas.hpp"

namespace taut::renderer {

/// The text of the colour bar of a ScalarColours.
struct Legend {
  std::string title;     ///< e.g. "stretch"
  float minimum = 0.0F;  ///< value at the lower end of the bar
  float maximum = 1.0F;  ///< value at the upper end; above minimum
  ColourMap map = ColourMap::viridis;
  float factor = 1.0F;                ///< values are printed times this, e.g. 100 with suffix " %" for fractions
  std::string suffix;                 ///< printed behind every value
  std::optional<float> bound;         ///< a value to mark on the bar, in the unit of minimum and maximum
  std::string bound_label = "bound";  ///< printed next to the mark
  bool more_above = false;            ///< draws an arrow head: some values are above maximum
};

/// Where a legend is drawn, in pixels of the canvas.
struct LegendPlace {
  float x_px = 24.0F;  ///< upper left corner of the bar; the title is above, the values are to the right
  float y_px = 48.0F;
  float bar_width_px = 16.0F;
  float bar_height_px = 240.0F;
  TextStyle text;  ///< of title and values
};

/// Draws a vertical colour bar with ticks at round values.
void draw_legend(Canvas& canvas, const Legend& legend, const LegendPlace& place = {});

}  // namespace taut::renderer
