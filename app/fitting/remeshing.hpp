#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Makes triangles of one size that are near equilateral, on the same surface (Botsch and Kobbelt 2004, A
/// Remeshing Approach to Multiresolution Modeling). Borders stay on the borders, their corners in place.
/// Requires a mesh with two triangles at most at every edge, one fan at every vertex, and neighbours that
/// face the same side.
sim::Mesh remesh(const sim::Mesh& surface, double edge_m);

}  // namespace taut::app
