#pragma once

#include <cstdint>
#include <vector>

#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// Sparse matrix whose rows sum to zero, stored without its diagonal. Rows lie side by side in slices of `block_size`
/// rows. A slice is as long as its longest row; rows of similar length share a slice (SELL, Kreutzer and others 2014).
struct SlicedMatrix {
  /// Start of each slice's entries, in blocks; number of slices + 1 entries.
  std::vector<std::uint32_t> begin;
  /// Offset of each lane's row in floats.
  Lanes<std::uint32_t> row_at;
  /// Offset of each entry's column in floats. The k-th entries of all rows of a slice lie together.
  Lanes<std::uint32_t> column_at;
  Lanes<float> value;  ///< per entry; 0 where a row is shorter than its slice

  std::size_t slice_count() const { return begin.empty() ? 0 : begin.size() - 1; }
};

/// Entry of an input row.
struct MatrixEntry {
  Index column;
  double value;
};

/// Makes the matrix from the entries of each row. Unused lanes of the last slice take up to `block_size` padding rows
/// after the last row.
SlicedMatrix make_sliced_matrix(const std::vector<std::vector<MatrixEntry>>& rows);

/// Does result += matrix times `vector` in double precision, in the order of the entries of each row.
void add_product(const SlicedMatrix& matrix, const std::vector<double>& vector, std::vector<double>& result);

}  // namespace taut::sim::bounded
