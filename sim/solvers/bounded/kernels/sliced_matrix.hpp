#pragma once

#include <cstdint>
#include <vector>

#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// A sparse matrix whose rows sum to zero, stored without its diagonal. Rows lie side by side in slices of
/// `block_size` rows. A slice is as long as its longest row; rows of similar length share a slice (SELL,
/// Kreutzer and others 2014).
struct SlicedMatrix {
  /// Where the entries of each slice begin, in blocks; the number of slices + 1 entries.
  std::vector<std::uint32_t> begin;
  /// Per lane of all slices, where its row begins, counted in floats.
  Lanes<std::uint32_t> row_at;
  /// Per entry, where the row of its column begins, counted in floats. The k-th entries of all rows of a
  /// slice lie together.
  Lanes<std::uint32_t> column_at;
  Lanes<float> value;  ///< per entry; 0 where a row is shorter than its slice

  std::size_t slice_count() const { return begin.empty() ? 0 : begin.size() - 1; }
};

/// An entry of a row that is given.
struct MatrixEntry {
  Index column;
  double value;
};

/// Makes the matrix from the entries of each row. Unused lanes of the last slice take spare rows after the
/// last row, up to `block_size` of them.
SlicedMatrix make_sliced_matrix(const std::vector<std::vector<MatrixEntry>>& rows);

/// result += matrix times `vector`, in double precision, one number per row, in the order of the entries of
/// each row.
void add_product(const SlicedMatrix& matrix, const std::vector<double>& vector, std::vector<double>& result);

}  // namespace taut::sim::bounded
