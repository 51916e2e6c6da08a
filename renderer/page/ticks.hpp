#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// Returns value truncated and clamped to lowest..highest; NaN gives lowest. Casting a float that no int can
/// hold is undefined, and positions may be anywhere.
inline int whole_within(float value, int lowest, int highest) {
  if (!(value > static_cast<float>(lowest))) return lowest;
  return value < static_cast<float>(highest) ? static_cast<int>(value) : highest;
}

// Round numbers along a scale. In the scale's own precision, float or double: the last bit of a number can
// decide to which pixel its tick is rounded.

/// 1, 2 or 5 times a power of ten: the step that gives about six ticks in a range above 0.
template <class Number> Number round_step(Number range) {
  const Number rough = range / Number(6.0);
  const Number power = std::pow(Number(10.0), std::floor(std::log10(rough)));
  for (const Number factor : {Number(1.0), Number(2.0), Number(5.0)}) {
    if (factor * power >= rough * Number(0.999)) return factor * power;
  }
  return Number(10.0) * power;
}

/// The multiples of `step` from minimum to maximum, ascending.
template <class Number> std::vector<Number> multiples_within(Number minimum, Number maximum, Number step) {
  const Number slack = Number(0.001);
  std::vector<Number> values;
  for (Number i = std::ceil(minimum / step - slack); i * step <= maximum + slack * step; i += Number(1.0)) {
    values.push_back(i * step);
  }
  return values;
}

/// A multiple of `step` with as many decimals as the step has, at most 40.
template <class Number> std::string tick_text(Number value, Number step) {
  const int decimals = whole_within(static_cast<float>(std::ceil(-std::log10(step) - Number(0.001))), 0, 40);
  char text[384];
  // Adding zero turns a minus zero into zero.
  std::snprintf(text, sizeof text, "%.*f", decimals, static_cast<double>(value) + 0.0);
  return text;
}

}  // namespace taut::renderer
