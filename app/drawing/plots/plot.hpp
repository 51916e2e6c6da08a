#pragma once

#include "app/drawing/drawing.hpp"

namespace taut::app {

/// How a line looks. `dashes` holds lengths of dashes and gaps in turn, as multiples of the thickness. Empty:
/// a solid line.
struct Stroke {
  renderer::Colour colour{0.0F};
  float thickness_px = 4.0F;
  std::vector<float> dashes;
};

/// Draws a line through the points in their order. Dashes continue around corners.
void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke);

/// The pieces of the line that are drawn. A solid line is one piece.
std::vector<std::vector<glm::vec2>> cut_into_dashes(std::span<const glm::vec2> points, const Stroke& stroke);

/// A curved line from a to b. In its middle it is away from the straight line by `sideways` times its length.
std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways);

/// At most four points for each column of pixels. The curve looks the same, because the lowest and the
/// highest point of each column stay.
std::vector<glm::vec2> thinned_out(std::span<const glm::vec2> points);

/// One axis of a plot.
struct Axis {
  std::string label;
  double minimum = 0.0;
  double maximum = 1.0;  ///< larger than minimum; both must be above 0 if logarithmic
  bool logarithmic = false;
  std::string suffix = {};  ///< printed after every number, such as " %"
  /// Values to label instead of round ones, such as the sizes of models. Empty: round values.
  std::vector<double> chosen = {};
};

/// A mark on an axis.
struct Tick {
  double value = 0.0;
  std::string label;  ///< empty for small ticks
};

/// The ticks within the axis, ascending. A linear axis has about six round values. A logarithmic axis has the
/// powers of ten, with small ticks at their multiples. If it spans less than two decades, it has 1, 2 and 5
/// times the powers of ten.
std::vector<Tick> ticks_of(const Axis& axis);

/// Position of a value along the axis: 0 at the minimum, 1 at the maximum. Values outside give less than 0 or
/// more than 1.
double position_on(const Axis& axis, double value);

/// A logarithmic axis of whole decades around the values. Values of 0 or less are ignored.
Axis decades_around(std::string label, const std::vector<double>& values);

/// "10" with the exponent as superscript.
std::string power_of_ten(int exponent);

/// A number with two digits, and a power of ten if it is very large or small: "1.9", "2.2 × 10⁻⁸".
std::string scientific(double value);

/// x and y.
using DataPoint = std::array<double, 2>;

/// The mark at each point of a curve.
enum class Marker { none, disc, square, ring, cross };

/// One series of points in a plot.
struct Curve {
  std::string name;  ///< text in the legend; empty: no entry
  std::vector<DataPoint> points;
  Stroke stroke;  ///< thickness 0: no line, markers only
  Marker marker = Marker::none;
  std::vector<DataPoint> bars = {};  ///< Error bars: smallest and largest y for each point. Empty: none.
};

/// A horizontal line across the plot, labelled at its end.
struct Level {
  double y = 0.0;
  std::string label;
};

/// Where the legend is.
enum class LegendCorner { none, upper_left, upper_right, lower_left, lower_right };

/// Axes, curves and legend of one plot.
struct Plot {
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Level> levels = {};
  LegendCorner legend = LegendCorner::upper_right;
};

/// A rectangle on a canvas. x and y are its upper left corner.
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

/// Draws the plot with its numbers and labels within `area`. Curves are cut at the edge of the data area. A
/// point that is not finite, or not positive on a logarithmic axis, leaves a gap.
void draw_plot(renderer::Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style = {});

/// Draws a sample of a curve, beginning at left_px, with its name to the right of it.
void draw_legend_entry(renderer::Canvas& canvas, const Curve& curve, float left_px, float middle_px,
                       const PlotStyle& style = {});

/// The rectangle within `area` that holds the curves, for the same arguments as draw_plot.
Area data_area_of(const renderer::Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style = {});

/// The part of the segment a-b within the rectangle, or nothing (Liang and Barsky 1984).
std::optional<std::array<glm::vec2, 2>> clipped(const glm::vec2& a, const glm::vec2& b, const Area& area);

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
