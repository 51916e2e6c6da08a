#pragma once

#include <array>
#include <span>

namespace taut::app {

/// y = offset + slope * x.
struct StraightLine {
  double slope = 0.0;
  double offset = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the points along y
};

/// Fits a line by least squares. The points need at least two different x; otherwise no member is finite.
StraightLine fit_line(std::span<const std::array<double, 2>> points);

/// y = factor * x^exponent.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the logarithms of y
};

/// Fits the law by least squares on the logarithms of x and y. All coordinates must be above 0, with at least
/// two different x; otherwise no member is finite.
PowerLaw fit_power_law(std::span<const std::array<double, 2>> points);

}  // namespace taut::app
