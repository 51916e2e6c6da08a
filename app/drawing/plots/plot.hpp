#pragma once

#include "app/drawing/drawing.hpp"

namespace taut::app {

/// Style of a line. `dashes`: lengths of alternating dashes and gaps, as multiples of the thickness; empty: a solid
/// line.
struct Stroke {
  renderer::Colour colour{0.0F};
  float thickness_px = 4.0F;
  std::vector<float> dashes;
};

/// Draws a line through the points in order. Dashes continue around corners.
void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke);

/// Returns a curve from a to b, whose middle is away from the straight line by `sideways` times its length.
std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways);

/// Returns at most four points for each column of pixels. The curve looks the same, because the lowest and the highest
/// point of each column stay.
std::vector<glm::vec2> thin_out(std::span<const glm::vec2> points);

/// One axis of a plot.
struct Axis {
  std::string label;
  double minimum = 0.0;
  double maximum = 1.0;  ///< larger than minimum; a logarithmic axis needs both above 0
  bool logarithmic = false;
  std::string suffix = {};  ///< printed after every number, such as " %"
  /// Values to label instead of round ones, such as the sizes of models; empty: round values.
  std::vector<double> chosen = {};
};

/// A mark on an axis.
struct Tick {
  double value = 0.0;
  std::string label;  ///< empty for small ticks
};

/// Returns the ticks within the axis, ascending. A linear axis has about six round values. A logarithmic axis has the
/// powers of ten, with small ticks at their multiples; below two decades it has 1, 2 and 5 times the powers of ten.
std::vector<Tick> make_ticks(const Axis& axis);

/// Returns the position of a value along the axis: 0 at the minimum, 1 at the maximum, and beyond these for values
/// outside.
double position_on(const Axis& axis, double value);

/// Returns a logarithmic axis of whole decades around the values. Ignores values of 0 or less.
Axis decades_around(std::string label, const std::vector<double>& values);

/// Returns "10" with the exponent as superscript.
std::string power_of_ten(int exponent);

/// Returns a number with two digits, and a power of ten if it is very large or small: "1.9", "2.2 × 10⁻⁸".
std::string scientific(double value);

/// Coordinates x and y.
using DataPoint = std::array<double, 2>;

/// Mark at each point of a curve.
enum class Marker { none, disc, square, ring, cross };

/// A series of points in a plot.
struct Curve {
  std::string name;  ///< text in the legend; empty: no entry
  std::vector<DataPoint> points;
  Stroke stroke;  ///< thickness 0: markers without a line
  Marker marker = Marker::none;
  std::vector<DataPoint> bars = {};  ///< error bars: smallest and largest y for each point; empty: none
};

/// A horizontal line across the plot, labelled at its end.
struct LegendLevel {
  double y = 0.0;
  std::string label;
};

/// Position of the legend.
enum class LegendCorner { none, upper_left, upper_right, lower_left, lower_right };

/// A plot: axes, curves and legend.
struct Plot {
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<LegendLevel> levels = {};
  LegendCorner legend = LegendCorner::upper_right;
};

/// Rectangle on a canvas. x and y are its upper left corner.
struct Area {
  float x_px = 0.0F;
  float y_px = 0.0F;
  float width_px = 0.0F;
  float height_px = 0.0F;
};

/// Sizes in a plot.
struct PlotStyle {
  float text_px = 34.0F;
  float line_px = 2.5F;
  float tick_px = 12.0F;
  float marker_px = 11.0F;  ///< radius
};

/// Draws the plot with its numbers and labels within `area`. Curves are clipped at the data area. A point that is not
/// finite, or not positive on a logarithmic axis, leaves a gap.
void draw_plot(renderer::Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style = {});

/// Draws a sample of a curve from left_px, with the curve's name to the right of it.
void draw_legend_entry(renderer::Canvas& canvas, const Curve& curve, float left_px, float middle_px,
                       const PlotStyle& style = {});

/// Returns the rectangle within `area` that contains the curves, for the same arguments as draw_plot.
Area compute_data_area(const renderer::Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style = {});

/// A plot with its caption.
struct PlotPanel {
  Plot plot;
  Caption caption;
};

/// Arrangement of plots on a page, row by row.
struct PlotSheet {
  std::size_t columns = 2;
  float left_px = 20.0F;     ///< margin left of the first column
  float right_px = 60.0F;    ///< margin right of the last column
  float top_px = 15.0F;      ///< margin above the first row and below the last row
  float width_px = 1160.0F;  ///< width of a plot with its labels
  float height_px = 800.0F;
  float gap_px = 40.0F;     ///< between columns
  float row_gap_px = 0.0F;  ///< below each caption
  CaptionStyle caption = {.text_px = 38.0F, .measured_px = 34.0F};
  PlotStyle plot = {};
};

/// Returns the area of the plot with this number, without its caption.
Area plot_area(const PlotSheet& sheet, std::size_t number);

/// Draws a page with these plots. It has at least one row.
Drawing draw_plot_sheet(std::vector<PlotPanel> panels, const PlotSheet& sheet);

}  // namespace taut::app
