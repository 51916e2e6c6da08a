#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim::bounded {

/// Greedy colouring: each element gets the first colour that no earlier one at its rows has. Elements are the
/// `corners` rows that each of them moves. Returns the numbers of the elements of each colour, in order.
template <std::size_t corners>
std::vector<std::vector<std::size_t>> coloured(const std::vector<std::array<Index, corners>>& elements,
                                               std::size_t row_count) {
  std::vector<std::vector<std::size_t>> colours;
  std::vector<std::vector<bool>> taken;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::array<Index, corners>& rows = elements[e];
    std::size_t c = 0;
    while (c < colours.size() && std::any_of(rows.begin(), rows.end(), [&](Index row) { return taken[c][row]; })) {
      ++c;
    }
    if (c == colours.size()) {
      colours.emplace_back();
      taken.emplace_back(row_count, false);
    }
    colours[c].push_back(e);
    for (const Index row : rows) taken[c][row] = true;
  }
  return colours;
}

}  // namespace taut::sim::bounded
