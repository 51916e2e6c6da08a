#pragma once

#include "prelude.hpp"

namespace taut::app {

/// The value at place `fraction` (0 to 1) of the sorted values, between two places the lower. It is always
/// one of the values, as a count of steps must be. `values` must not be empty.
template <class Number> Number ranked(std::vector<Number> values, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The median of the values, which must not be empty. For an even number of values it is the mean of the two
/// in the middle. `ranked(values, 0.5)` is the lower of the two.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

}  // namespace taut::app
