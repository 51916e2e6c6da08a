#include "sim/solvers/bounded/kernels/sliced_matrix.hpp"

#include <algorithm>

namespace taut::sim::bounded {
namespace {

/// Number of neighbouring rows sorted by length. Larger values pad less and access memory less in order.
constexpr std::size_t rows_sorted_together = 32 * block_size;

/// Returns the rows with longer ones before shorter ones within each group of `rows_sorted_together`. Empty rows are
/// left out.
std::vector<Index> order_of_slices(const std::vector<std::vector<MatrixEntry>>& rows) {
  std::vector<Index> order;
  for (Index row = 0; row < rows.size(); ++row) {
    if (!rows[row].empty()) order.push_back(row);
  }
  for (std::size_t begin = 0; begin < order.size(); begin += rows_sorted_together) {
    const std::size_t end = std::min(begin + rows_sorted_together, order.size());
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                     order.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](Index a, Index b) { return rows[a].size() > rows[b].size(); });
  }
  return order;
}

void set_lane(SlicedMatrix& matrix, std::size_t lane, Index row, const std::vector<MatrixEntry>& entries) {
  const std::size_t slice = lane / block_size;
  matrix.row_at[lane] = 4 * row;
  for (std::size_t b = matrix.begin[slice]; b < matrix.begin[slice + 1]; ++b) {
    const std::size_t k = b - matrix.begin[slice];
    const std::size_t at = b * block_size + lane % block_size;
    matrix.column_at[at] = 4 * (k < entries.size() ? entries[k].column : row);
    matrix.value[at] = k < entries.size() ? static_cast<float>(entries[k].value) : 0.0F;
  }
}

}  // namespace

SlicedMatrix make_sliced_matrix(const std::vector<std::vector<MatrixEntry>>& rows) {
  const std::vector<Index> order = order_of_slices(rows);
  SlicedMatrix matrix;
  matrix.begin.push_back(0);
  for (std::size_t first = 0; first < order.size(); first += block_size) {
    matrix.begin.push_back(matrix.begin.back() + static_cast<std::uint32_t>(rows[order[first]].size()));
  }
  matrix.row_at.resize(matrix.slice_count() * block_size);
  matrix.column_at.resize(matrix.begin.back() * block_size);
  matrix.value.resize(matrix.begin.back() * block_size);
  for (std::size_t lane = 0; lane < matrix.row_at.size(); ++lane) {
    if (lane < order.size()) {
      set_lane(matrix, lane, order[lane], rows[order[lane]]);
    } else {
      set_lane(matrix, lane, static_cast<Index>(rows.size() + lane % block_size), {});
    }
  }
  return matrix;
}

void add_product(const SlicedMatrix& matrix, const std::vector<double>& vector, std::vector<double>& result) {
  assert(vector.size() == result.size());
  for (std::size_t lane = 0; lane < matrix.row_at.size(); ++lane) {
    const std::size_t slice = lane / block_size;
    const std::size_t row = matrix.row_at[lane] / 4;
    for (std::size_t b = matrix.begin[slice]; row < result.size() && b < matrix.begin[slice + 1]; ++b) {
      const std::size_t at = b * block_size + lane % block_size;
      const double to_column = vector[matrix.column_at[at] / 4] - vector[row];
      result[row] += static_cast<double>(matrix.value[at]) * to_column;
    }
  }
}

}  // namespace taut::sim::bounded
