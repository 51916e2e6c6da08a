#pragma once

#include <cstddef>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Counts of triangles without area, by what became of them.
struct FlatFaces {
  std::size_t left_out = 0;  ///< two corners or all three were at one place
  std::size_t turned = 0;    ///< the corners were in a line
};

/// Mends triangles without area, as remeshing, the splitting of polygons and few digits leave them. The ends
/// of an edge without length become one vertex, and its triangles are left out. Of a triangle with its
/// corners in a line the long edge is turned: it and the triangle across become two that meet at the corner
/// in the middle. It stays where that edge has not two triangles, or if turning does not help. No vertex is
/// moved, nothing is opened.
FlatFaces mend_flat_faces(sim::Mesh& soup);

}  // namespace taut::app
