#include "sim/mesh/adjacency.hpp"

#include <algorithm>
#include <numeric>

namespace taut::sim {
namespace {

struct HalfEdge {
  Index high, triangle;
};

/// Edges of triangles by their lower vertex, of each the higher one and the triangle, ascending.
struct HalfEdges {
  std::vector<std::size_t> offsets;  ///< by lower vertex
  std::vector<HalfEdge> items;
};

HalfEdges sorted_half_edges(const Mesh& mesh) {
  HalfEdges sorted{std::vector<std::size_t>(mesh.positions.size() + 1, 0),
                   std::vector<HalfEdge>(mesh.triangles.size() * 3)};
  const auto for_all = [&mesh](const auto& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
        visit(low, HalfEdge{high, static_cast<Index>(t)});
      }
    }
  };
  for_all([&](Index low, const HalfEdge&) { ++sorted.offsets[low + 1]; });
  std::partial_sum(sorted.offsets.begin(), sorted.offsets.end(), sorted.offsets.begin());
  std::vector<std::size_t> next = sorted.offsets;
  for_all([&](Index low, const HalfEdge& half) { sorted.items[next[low]++] = half; });
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    std::sort(sorted.items.data() + sorted.offsets[v], sorted.items.data() + sorted.offsets[v + 1],
              [](const HalfEdge& a, const HalfEdge& b) {
                return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
              });
  }
  return sorted;
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
  const HalfEdges halves = sorted_half_edges(mesh);
  for (Index low = 0; low < mesh.positions.size(); ++low) {
    for (std::size_t i = halves.offsets[low]; i < halves.offsets[low + 1]; ++i) {
      const HalfEdge& half = halves.items[i];
      if (i == halves.offsets[low] || half.high != halves.items[i - 1].high) {
        adjacency.edges.push_back({low, half.high});
        adjacency.edge_triangles.offsets.push_back(adjacency.edge_triangles.offsets.back());
      }
      adjacency.edge_triangles.items.push_back(half.triangle);
      ++adjacency.edge_triangles.offsets.back();
    }
  }
  adjacency.vertex_edges = edges_of_vertices(mesh.positions.size(), adjacency.edges);
  return adjacency;
}

}  // namespace taut::sim
