#include "sim/mesh/adjacency.hpp"

#include <algorithm>

namespace taut::sim {
namespace {

struct HalfEdge {
  Edge edge;
  Index triangle;
};

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(mesh.triangles.size() * 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& tri = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(tri[k], tri[(k + 1) % 3]);
      half_edges.push_back({{low, high}, static_cast<Index>(t)});
    }
  }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  });
  return half_edges;
}

}  // namespace

CompressedRows edges_of_vertices(std::size_t vertex_count, std::span<const Edge> edges) {
  CompressedRows rows;
  rows.offsets.assign(vertex_count + 1, 0);
  for (const Edge& e : edges) {
    ++rows.offsets[e[0] + 1];
    ++rows.offsets[e[1] + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    rows.offsets[v + 1] += rows.offsets[v];
  }
  rows.items.resize(edges.size() * 2);
  std::vector<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const Index v : edges[e]) {
      rows.items[next[v]++] = static_cast<Index>(e);
    }
  }
  return rows;
}

Adjacency make_adjacency(const Mesh& mesh) {
  Adjacency adjacency;
  adjacency.edge_triangles.offsets.push_back(0);
  for (const HalfEdge& half : sorted_half_edges(mesh)) {
    if (adjacency.edges.empty() || adjacency.edges.back() != half.edge) {
      adjacency.edges.push_back(half.edge);
      adjacency.edge_triangles.offsets.push_back(adjacency.edge_triangles.offsets.back());
    }
    adjacency.edge_triangles.items.push_back(half.triangle);
    ++adjacency.edge_triangles.offsets.back();
  }
  adjacency.vertex_edges = edges_of_vertices(mesh.positions.size(), adjacency.edges);
  return adjacency;
}

}  // namespace taut::sim
