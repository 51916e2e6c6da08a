#pragma once

#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// A mesh and the vertices it is held by.
struct PinnedMesh {
  Mesh mesh;
  std::vector<Index> pins;  ///< ascending, each once
};

/// Every triangle becomes four by the midpoints of its edges; triangle t becomes 4t to 4t + 3, the corners
/// first and the middle last. The surface keeps its shape: nothing is smoothed. Vertices keep their numbers,
/// the midpoints follow in the order of the mesh's edges (`make_adjacency`). The midpoint of a border edge
/// whose two ends are pinned is pinned as well, so that a held border stays held all along.
/// Throws std::invalid_argument on a mesh with grid cells: a grid is made with more rows instead.
PinnedMesh subdivide(const PinnedMesh& coarse);

}  // namespace taut::sim
