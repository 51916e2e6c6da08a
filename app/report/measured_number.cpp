#include "app/report/measured_number.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/drawing/plots/axis.hpp"

namespace taut::app {

std::string number_text(const MeasuredNumber& number) {
  if (!std::isfinite(number.value)) {
    return "diverged";
  }
  std::string digits = fmt::format("{:.{}g}", number.value, number.digits);
  if (std::abs(number.value) >= 10.0 && std::abs(number.value) < 1e6) {
    // Never 8.5e+02, and no noughts behind a number of things.
    const bool is_whole = std::abs(number.value - std::round(number.value)) < 1e-9;
    const int decimals =
        is_whole ? 0 : std::max(0, number.digits - 1 - static_cast<int>(std::log10(std::abs(number.value))));
    digits = fmt::format("{:.{}f}", number.value, decimals);
  }
  const std::size_t e = digits.find('e');
  if (e != std::string::npos) {
    digits = digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
  }
  return digits + (number.unit.empty() ? "" : " ") + number.unit;
}

std::string text_of(double value, const std::string& unit) {
  return number_text({"", value, unit, 2});
}

std::string percent_text(double fraction) {
  return text_of(100.0 * fraction, "%");
}

MeasuredNumber percent_number(std::string name, double fraction) {
  return {std::move(name), 100.0 * fraction, "%", 3};
}

MeasuredNumber count_number(std::string name, std::size_t count) {
  return {std::move(name), static_cast<double>(count), "", 6};
}

}  // namespace taut::app
