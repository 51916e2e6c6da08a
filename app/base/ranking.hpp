#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taut::app {

/// Of at least one value the one that `fraction` (0 to 1) of the others do not exceed, between two of them
/// the lower: always one of the values, as a count of steps has to be.
template <class Number>
Number ranked(std::vector<Number> values, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The middle of at least one value, of an even number the mean of the two in the middle. That is not
/// `ranked(values, 0.5)`, the lower of the two.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

}  // namespace taut::app
