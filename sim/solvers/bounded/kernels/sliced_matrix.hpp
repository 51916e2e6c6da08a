#pragma once

#include <cstdint>
#include <vector>

#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// A sparse matrix without its diagonal: with it every row would sum to zero. Rows lie side by side in slices
/// of as many as a block has, each slice as long as its longest row; rows of like lengths share one (SELL,
/// Kreutzer and others 2014).
struct SlicedMatrix {
  std::vector<std::uint32_t> begin;  ///< of each slice's entries, in blocks of them; one more than slices
  Lanes<std::uint32_t> row_at;       ///< by lane of all slices, where the row begins, counted in floats
  Lanes<std::uint32_t> column_at;    ///< of each entry, likewise; the k-th entries of a slice's rows together
  Lanes<float> value;                ///< 0 where a row is shorter than its slice

  std::size_t slice_count() const { return begin.empty() ? 0 : begin.size() - 1; }
};

struct MatrixEntry {
  Index column;
  double value;
};

/// From the entries of each row. Lanes left over take up to `block_size` spare rows after the last.
SlicedMatrix make_sliced_matrix(const std::vector<std::vector<MatrixEntry>>& rows);

/// result += matrix times `vector`, one number a row, in the order of the rows' entries.
void add_product(const SlicedMatrix& matrix, const std::vector<double>& vector, std::vector<double>& result);

}  // namespace taut::sim::bounded
