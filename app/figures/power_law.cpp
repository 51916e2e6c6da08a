#include "app/figures/power_law.hpp"

#include <cmath>

namespace taut::app {

PowerLaw fit_power_law(std::span<const std::array<double, 2>> points) {
  const auto n = static_cast<double>(points.size());
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (const auto& point : points) {
    const double x = std::log(point[0]), y = std::log(point[1]);
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  const double exponent = (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
  return {exponent, std::exp((sum_y - exponent * sum_x) / n)};
}

}  // namespace taut::app
