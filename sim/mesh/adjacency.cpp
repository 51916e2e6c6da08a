#include "sim/mesh/adjacency.hpp"

namespace taut::sim {
namespace {

/// Returns rows of triangle sides; side k of triangle t is 3 t + k. Row v lists the sides with the lower end v, ordered
/// by higher end, then side.
CompressedRows sides_by_lower_end(const Mesh& mesh, std::span<const Edge> ends) {
  CompressedRows sides = group_by_row(mesh.positions.size(), [&](const auto& visit) {
    for (std::size_t side = 0; side < ends.size(); ++side) visit(ends[side][0], static_cast<Index>(side));
  });
  for (std::size_t v = 0; v < sides.size(); ++v) {
    std::sort(sides.items.begin() + sides.offsets[v], sides.items.begin() + sides.offsets[v + 1],
              [&](Index a, Index b) { return std::pair(ends[a][1], a) < std::pair(ends[b][1], b); });
  }
  return sides;
}

std::vector<Edge> ends_of_sides(const Mesh& mesh) {
  std::vector<Edge> ends;
  ends.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      ends.push_back({low, high});
    }
  }
  return ends;
}

}  // namespace

Adjacency make_adjacency(const Mesh& mesh) {
  Adjacency adjacency;
  adjacency.edge_triangles.offsets.push_back(0);
  const std::vector<Edge> ends = ends_of_sides(mesh);
  for (const Index side : sides_by_lower_end(mesh, ends).items) {
    if (adjacency.edges.empty() || adjacency.edges.back() != ends[side]) {
      adjacency.edges.push_back(ends[side]);
      adjacency.edge_triangles.offsets.push_back(adjacency.edge_triangles.offsets.back());
    }
    adjacency.edge_triangles.items.push_back(side / 3);
    ++adjacency.edge_triangles.offsets.back();
  }
  adjacency.vertex_edges = at_vertices(mesh.positions.size(), adjacency.edges);
  return adjacency;
}

Index edge_between(const Adjacency& adjacency, Index a, Index b) {
  assert(a != b);
  const auto& edges = adjacency.edges;
  const auto found = std::lower_bound(edges.begin(), edges.end(), Edge{std::min(a, b), std::max(a, b)});
  return static_cast<Index>(found - edges.begin());
}

}  // namespace taut::sim
