#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Mesh with pinned vertices.
struct PinnedMesh {
  Mesh mesh;
  std::vector<Index> pins;  ///< ascending, each once
};

/// Splits every triangle into four at the midpoints of its edges. Triangle t becomes 4t to 4t + 3: the three
/// corners, then the middle. The surface keeps its shape; nothing is smoothed. The old vertices keep their
/// indices; the midpoints follow in the order of the edges (`make_adjacency`). The midpoint of a border edge
/// is pinned if both ends of the edge are pinned, so that a pinned border stays pinned all along. Throws
/// std::invalid_argument on a mesh with grid cells: make the grid with more rows instead. Throws
/// std::out_of_range on a pin that is not a vertex.
PinnedMesh subdivide(const PinnedMesh& coarse);

}  // namespace taut::sim
