#include "sim/mesh/subdivide.hpp"

#include "sim/mesh/adjacency.hpp"

namespace taut::sim {
namespace {

std::vector<Index> pins_with_midpoints(const PinnedMesh& coarse, const Adjacency& adjacency) {
  std::vector<bool> is_pinned(coarse.mesh.positions.size(), false);
  for (const Index pin : coarse.pins) is_pinned.at(pin) = true;
  std::vector<Index> pins = coarse.pins;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto [a, b] = adjacency.edges[e];
    if (is_pinned[a] && is_pinned[b] && adjacency.edge_triangles[e].size() == 1) {
      pins.push_back(static_cast<Index>(is_pinned.size() + e));
    }
  }
  return pins;
}

}  // namespace

PinnedMesh subdivide(const PinnedMesh& coarse) {
  const Mesh& mesh = coarse.mesh;
  if (!mesh.quads.empty()) {
    throw std::invalid_argument("a regular grid cannot be subdivided; make it with more columns and rows");
  }
  const Adjacency adjacency = make_adjacency(mesh);
  PinnedMesh fine;
  fine.mesh.positions = mesh.positions;
  for (const auto& [a, b] : adjacency.edges) {
    fine.mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto corners = static_cast<Index>(mesh.positions.size());
    const Index ab = corners + edge_between(adjacency, a, b);
    const Index bc = corners + edge_between(adjacency, b, c);
    const Index ca = corners + edge_between(adjacency, c, a);
    fine.mesh.triangles.insert(fine.mesh.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  fine.pins = pins_with_midpoints(coarse, adjacency);
  return fine;
}

}  // namespace taut::sim
