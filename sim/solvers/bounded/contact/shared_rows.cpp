#include "sim/solvers/bounded/contact/shared_rows.hpp"

#include <map>

namespace taut::sim::bounded {

BlockLanePairs shared_rows(const PrimitiveLanes& a, const PrimitiveLanes& b) {
  BlockLanePairs all;
  std::vector<std::vector<std::uint32_t>> lanes_of_row;  // lanes of `b` by vertex
  for (std::size_t k = 0; k < b.corner_count; ++k) {
    for (std::uint32_t lane = 0; lane < b.count; ++lane) {
      const std::size_t row = b.at[k][lane] / 4;
      if (row >= lanes_of_row.size()) lanes_of_row.resize(row + 1);
      lanes_of_row[row].push_back(lane);
    }
  }
  for (std::size_t block = 0; block < a.block_count(); ++block) {
    std::map<std::uint32_t, LanePairs> shared;
    for (std::size_t lane = block * block_size; lane < std::min((block + 1) * block_size, a.count); ++lane) {
      for (std::size_t k = 0; k < a.corner_count; ++k) {
        const std::size_t row = a.at[k][lane] / 4;
        if (row >= lanes_of_row.size()) continue;
        for (const std::uint32_t other : lanes_of_row[row]) {
          std::uint16_t& lanes = shared[other / block_size][lane % block_size];
          lanes = static_cast<std::uint16_t>(lanes | 1U << other % block_size);
        }
      }
    }
    for (const auto& [other, lanes] : shared) {
      all.blocks.push_back(other);
      all.lanes.push_back(lanes);
    }
    all.begin.push_back(static_cast<std::uint32_t>(all.blocks.size()));
  }
  return all;
}

}  // namespace taut::sim::bounded
