#include "app/drawing/plots/axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/page/ticks.hpp"

namespace taut::app {
namespace {

// With more decades than this, only some ticks have labels, so that labels do not overlap.
constexpr double most_labelled_decades = 8.0;

std::vector<Tick> linear_ticks(const Axis& axis) {
  const double step = renderer::round_step(axis.maximum - axis.minimum);
  std::vector<Tick> ticks;
  for (const double value : renderer::multiples_within(axis.minimum, axis.maximum, step)) {
    ticks.push_back({value, renderer::tick_text(value, step) + axis.suffix});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Axis& axis) {
  const double decades = std::log10(axis.maximum / axis.minimum);
  const int every = static_cast<int>(std::ceil(decades / most_labelled_decades));
  // Powers where digits would have to be counted.
  const bool in_full = axis.minimum >= 0.0099 && axis.maximum <= 10001.0;
  std::vector<Tick> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(axis.minimum) + 1e-9));
       std::pow(10.0, exponent) <= axis.maximum * (1.0 + 1e-9); ++exponent) {
    for (int multiple = 1; multiple <= 9; ++multiple) {
      const double value = multiple * std::pow(10.0, exponent);
      if (value < axis.minimum * (1.0 - 1e-9) || value > axis.maximum * (1.0 + 1e-9)) {
        continue;
      }
      const bool is_labelled = decades < 2.0 ? multiple == 1 || multiple == 2 || multiple == 5
                                             : multiple == 1 && exponent % every == 0;
      std::string label;
      if (is_labelled) {
        label =
            (in_full || decades < 2.0 ? fmt::format("{:g}", value) : power_of_ten(exponent)) + axis.suffix;
      }
      ticks.push_back({value, std::move(label)});
    }
  }
  return ticks;
}

}  // namespace

std::vector<Tick> ticks_of(const Axis& axis) {
  if (!axis.chosen.empty()) {
    std::vector<Tick> ticks;
    for (const double value : axis.chosen) {
      ticks.push_back({value, fmt::format("{:g}", value) + axis.suffix});
    }
    return ticks;
  }
  return axis.logarithmic ? logarithmic_ticks(axis) : linear_ticks(axis);
}

double position_on(const Axis& axis, double value) {
  if (axis.logarithmic) {
    return std::log(value / axis.minimum) / std::log(axis.maximum / axis.minimum);
  }
  return (value - axis.minimum) / (axis.maximum - axis.minimum);
}

Axis decades_around(std::string label, const std::vector<double>& values) {
  double low = INFINITY, high = 0.0;
  for (const double value : values) {
    if (value > 0.0) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (high <= 0.0) {
    low = high = 1.0;
  }
  Axis axis{std::move(label), std::pow(10.0, std::floor(std::log10(low))),
            std::pow(10.0, std::ceil(std::log10(high))), true};
  if (!(axis.maximum > axis.minimum)) {
    axis.maximum = 10.0 * axis.minimum;
  }
  return axis;
}

std::string power_of_ten(int exponent) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    label += raised[digit - '0'];
  }
  return label;
}

std::string scientific(double value) {
  if (!(std::abs(value) > 0.0) || !std::isfinite(value)) {
    return fmt::format("{}", value);
  }
  if (std::abs(value) >= 0.1 && std::abs(value) < 1000.0) {
    return fmt::format("{:.2g}", value);
  }
  const std::string digits = fmt::format("{:.1e}", value);
  const std::size_t e = digits.find('e');
  return digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
}

}  // namespace taut::app
