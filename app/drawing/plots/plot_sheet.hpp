#pragma once

#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/drawing/plots/plot.hpp"

namespace taut::app {

/// A plot with the caption below it.
struct PlotPanel {
  Plot plot;
  Caption caption;
};

/// How plots are arranged on a page, row by row.
struct PlotSheet {
  std::size_t columns = 2;
  float left_px = 20.0F;     ///< beside the first column
  float right_px = 60.0F;    ///< beside the last one
  float top_px = 15.0F;      ///< above the first row and below the last one
  float width_px = 1160.0F;  ///< of a plot with its labels
  float height_px = 800.0F;
  float gap_px = 40.0F;     ///< between columns
  float row_gap_px = 0.0F;  ///< below each caption
  CaptionStyle caption = {.text_px = 38.0F, .measured_px = 34.0F};
  PlotStyle plot = {};
};

/// Where the plot with this number is on the page, without its caption.
Area plot_area(const PlotSheet& sheet, std::size_t number);

/// The page with these plots. It has at least one row.
Drawing draw_plot_sheet(std::vector<PlotPanel> panels, const PlotSheet& sheet);

}  // namespace taut::app
