#pragma once

#include <cstddef>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// A hole that was closed.
struct ClosedHole {
  double around = 0.0;    ///< length of its border, in the unit of the mesh
  sim::Index vertex = 0;  ///< one of its border
};

/// Closes each hole of the mesh whose border is at most `longest` long, in the unit of the mesh, by a fan of
/// triangles from the vertex of the border that gives its smallest triangle the largest area. No vertex is
/// added. A hole is left open if its border touches itself, or if each fan would have a triangle without
/// area or an edge that the mesh has. Returns what was closed, the largest hole first. Requires a mesh whose
/// triangles are turned to the side of their neighbours.
std::vector<ClosedHole> close_small_holes(double longest, sim::Mesh& mesh);

}  // namespace taut::app
