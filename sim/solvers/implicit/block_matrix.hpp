#pragma once

#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "sim/mesh/adjacency.hpp"

namespace taut::sim::implicit {

using Mat3 = glm::dmat3;

/// A symmetric matrix of 3 x 3 blocks, a row and a column for each vertex. All blocks are stored.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// The blocks that may differ from 0: those of each vertex with itself and those of `pairs`, which may
  /// repeat.
  BlockMatrix(std::size_t vertex_count, std::span<const Edge> pairs);

  void clear();
  /// Requires that the pair is one of those above. A row's blocks are in the order of their columns.
  Mat3& at(Index row, Index column);
  const Mat3& diagonal(Index row) const { return blocks_[diagonals_[row]]; }
  /// Fills `product` with the matrix times `vector`; one entry per vertex.
  void multiply(std::span<const Vec3> vector, std::span<Vec3> product) const;

 private:
  CompressedRows columns_;
  std::vector<std::size_t> diagonals_;
  std::vector<Mat3> blocks_;
};

}  // namespace taut::sim::implicit
