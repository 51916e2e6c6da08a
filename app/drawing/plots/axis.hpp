#pragma once

#include "renderer/page/canvas.hpp"

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

}  // namespace taut::app
