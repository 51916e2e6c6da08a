#include "app/figures/experiments/power_law.hpp"

#include <cmath>
#include <vector>

namespace taut::app {

StraightLine fit_line(std::span<const std::array<double, 2>> points) {
  const auto n = static_cast<double>(points.size());
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (const auto& [x, y] : points) {
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  StraightLine line;
  line.slope = (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
  line.offset = (sum_y - line.slope * sum_x) / n;
  double squares = 0.0;
  for (const auto& [x, y] : points) {
    const double distance = y - line.offset - line.slope * x;
    squares += distance * distance;
  }
  line.misfit = std::sqrt(squares / n);
  return line;
}

PowerLaw fit_power_law(std::span<const std::array<double, 2>> points) {
  std::vector<std::array<double, 2>> logarithms;
  for (const auto& [x, y] : points) {
    logarithms.push_back({std::log(x), std::log(y)});
  }
  const StraightLine line = fit_line(logarithms);
  return {line.slope, std::exp(line.offset), line.misfit};
}

}  // namespace taut::app
