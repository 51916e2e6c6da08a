#pragma once

#include <array>
#include <span>

namespace taut::app {

/// y = offset + slope x.
struct StraightLine {
  double slope = 0.0;
  double offset = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the points from it, along y
};

/// The line of least squares through points at no fewer than two different x; else nothing in it is finite.
StraightLine fit_line(std::span<const std::array<double, 2>> points);

/// y = factor x^exponent.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  double misfit = 0.0;  ///< root mean square distance of the logarithms of y
};

/// The line of least squares through the logarithms of the points, which have to be above 0 and at no fewer
/// than two different x; else nothing in it is finite.
PowerLaw fit_power_law(std::span<const std::array<double, 2>> points);

}  // namespace taut::app
