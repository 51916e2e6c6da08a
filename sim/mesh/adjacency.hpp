#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Compressed rows: row r holds items[offsets[r]] up to items[offsets[r + 1]].
struct CompressedRows {
  std::vector<Index> offsets;  ///< one more than there are rows
  std::vector<Index> items;

  std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t row) const {
    return std::span(items).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// The paper's link list: which edges meet at a vertex, which triangles meet at an edge.
struct Adjacency {
  std::vector<Edge> edges;        ///< each once, in lexicographic order
  CompressedRows vertex_edges;    ///< ascending within a row
  CompressedRows edge_triangles;  ///< ascending within a row; more than two at a non-manifold edge
};

Adjacency make_adjacency(const Mesh& mesh);

/// Row v lists the edges that end at vertex v. `edges` need not be sorted.
CompressedRows edges_of_vertices(std::size_t vertex_count, std::span<const Edge> edges);

/// The end of `edge` that is not `vertex`.
inline Index other_end(const Edge& edge, Index vertex) {
  return edge[0] == vertex ? edge[1] : edge[0];
}

}  // namespace taut::sim
