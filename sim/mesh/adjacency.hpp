#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Compressed sparse rows (CSR): row r holds items[offsets[r]] up to, not including, items[offsets[r + 1]].
struct CompressedRows {
  std::vector<Index> offsets;  ///< the number of rows + 1 entries
  std::vector<Index> items;

  /// The number of rows.
  std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t row) const {
    return std::span(items).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// The paper's link list: the edges that meet at each vertex and the triangles that meet at each edge.
struct Adjacency {
  std::vector<Edge> edges;      ///< each once, in lexicographic order
  CompressedRows vertex_edges;  ///< a row per vertex, ascending
  /// A row per edge, ascending; more than two triangles at a non-manifold edge.
  CompressedRows edge_triangles;
};

/// Requires that all indices of the mesh are in range.
Adjacency make_adjacency(const Mesh& mesh);

/// Row v lists the edges that end at vertex v, ascending. `edges` may be in any order. Requires ends below
/// `vertex_count`.
CompressedRows edges_of_vertices(std::size_t vertex_count, std::span<const Edge> edges);

/// Returns the end of `edge` that is not `vertex`. Requires that `edge` ends at `vertex`.
inline Index other_end(const Edge& edge, Index vertex) {
  return edge[0] == vertex ? edge[1] : edge[0];
}

}  // namespace taut::sim
