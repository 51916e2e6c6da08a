#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Compressed sparse rows (CSR): row r holds items[offsets[r]] up to, not including, items[offsets[r + 1]].
struct CompressedRows {
  std::vector<Index> offsets;  ///< number of rows + 1 entries
  std::vector<Index> items;

  std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t row) const {
    return std::span(items).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// Groups items by row. `for_all(visit)` calls visit(row, item) for each item, in the same order at every call; rows
/// keep that order. Requires rows below `row_count`.
template <typename ForAll> CompressedRows group_by_row(std::size_t row_count, const ForAll& for_all) {
  CompressedRows rows;
  rows.offsets.assign(row_count + 1, 0);
  for_all([&](Index row, Index) { ++rows.offsets[row + 1]; });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.items.resize(rows.offsets.back());
  std::vector<Index> next = rows.offsets;
  for_all([&](Index row, Index item) { rows.items[next[row]++] = item; });
  return rows;
}

/// Returns rows: row v lists the edges or triangles with the vertex v, ascending. Requires vertices below
/// `vertex_count`.
template <class Simplices> CompressedRows at_vertices(std::size_t vertex_count, const Simplices& simplices) {
  return group_by_row(vertex_count, [&](const auto& visit) {
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      for (const Index v : simplices[i]) visit(v, static_cast<Index>(i));
    }
  });
}

/// The paper's link list: the edges that meet at each vertex and the triangles that meet at each edge.
struct Adjacency {
  std::vector<Edge> edges;      ///< unique, in lexicographic order
  CompressedRows vertex_edges;  ///< one row per vertex, ascending
  /// One row per edge, ascending; more than two triangles at a non-manifold edge.
  CompressedRows edge_triangles;
};

/// Requires that all indices of the mesh are in range.
Adjacency make_adjacency(const Mesh& mesh);

/// Returns the edge between two vertices. Requires that there is one.
Index edge_between(const Adjacency& adjacency, Index a, Index b);

/// Returns the end of `edge` that is not `vertex`. Requires that `edge` ends at `vertex`.
inline Index other_end(const Edge& edge, Index vertex) { return edge[0] == vertex ? edge[1] : edge[0]; }

}  // namespace taut::sim
