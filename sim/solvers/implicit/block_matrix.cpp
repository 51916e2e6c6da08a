#include "sim/solvers/implicit/block_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace taut::sim::implicit {

BlockMatrix::BlockMatrix(std::size_t vertex_count, std::span<const Edge> pairs) {
  std::vector<std::vector<Index>> rows(vertex_count);
  for (Index v = 0; v < vertex_count; ++v) {
    rows[v].push_back(v);
  }
  for (const Edge& pair : pairs) {
    rows[pair[0]].push_back(pair[1]);
    rows[pair[1]].push_back(pair[0]);
  }
  columns_.offsets.push_back(0);
  for (Index v = 0; v < vertex_count; ++v) {
    std::sort(rows[v].begin(), rows[v].end());
    rows[v].erase(std::unique(rows[v].begin(), rows[v].end()), rows[v].end());
    const auto diagonal = std::find(rows[v].begin(), rows[v].end(), v) - rows[v].begin();
    diagonals_.push_back(columns_.items.size() + static_cast<std::size_t>(diagonal));
    columns_.items.insert(columns_.items.end(), rows[v].begin(), rows[v].end());
    columns_.offsets.push_back(static_cast<Index>(columns_.items.size()));
  }
  blocks_.resize(columns_.items.size());
}

void BlockMatrix::clear() {
  std::fill(blocks_.begin(), blocks_.end(), Mat3(0.0));
}

Mat3& BlockMatrix::at(Index row, Index column) {
  const std::span<const Index> columns = columns_[row];
  const auto found = std::lower_bound(columns.begin(), columns.end(), column);
  assert(found != columns.end() && *found == column);
  return blocks_[columns_.offsets[row] + static_cast<std::size_t>(found - columns.begin())];
}

void BlockMatrix::multiply(std::span<const Vec3> vector, std::span<Vec3> product) const {
  assert(vector.size() == columns_.size() && product.size() == columns_.size());
  for (std::size_t row = 0; row < columns_.size(); ++row) {
    Vec3 sum(0.0);
    for (std::size_t at = columns_.offsets[row]; at < columns_.offsets[row + 1]; ++at) {
      sum += blocks_[at] * vector[columns_.items[at]];
    }
    product[row] = sum;
  }
}

}  // namespace taut::sim::implicit
