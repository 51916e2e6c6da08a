#pragma once

#include <string>
#include <vector>

namespace taut::app {

/// One axis of a plot.
struct Axis {
  std::string label;
  double minimum = 0.0;
  double maximum = 1.0;  ///< above minimum; both above 0 where logarithmic
  bool logarithmic = false;
  std::string suffix = {};  ///< behind every number, such as " %"
  /// Numbers to be labelled instead of round ones, such as the sizes of models.
  std::vector<double> chosen = {};
};

struct Tick {
  double value = 0.0;
  std::string label;  ///< empty for the small ones between the decades
};

/// Round numbers within the axis, ascending: about six on a linear axis; the decades on a logarithmic one
/// with small ticks at their multiples, or 1, 2 and 5 times the decades where the axis spans less than two.
std::vector<Tick> ticks_of(const Axis& axis);

/// Where a value lies, 0 at the minimum and 1 at the maximum; beyond for values outside.
double position_on(const Axis& axis, double value);

/// The axis widened to whole decades around the values. Values of 0 or less are left out of account.
Axis decades_around(std::string label, const std::vector<double>& values);

/// "10" with the exponent raised.
std::string power_of_ten(int exponent);

/// Two digits, and a power of ten where there would be many noughts: "1.9", "2.2 × 10⁻⁸".
std::string scientific(double value);

}  // namespace taut::app
