#pragma once

#include <cstddef>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// The shape of a surface, whatever its geometry.
struct Topology {
  std::size_t components = 0;
  std::size_t boundary_edges = 0;         ///< with one triangle
  std::size_t boundary_loops = 0;         ///< connected runs of boundary edges
  std::size_t non_manifold_edges = 0;     ///< with more than two triangles
  std::size_t non_manifold_vertices = 0;  ///< whose triangles form more than one fan
  std::size_t misoriented_edges = 0;      ///< whose two triangles run along them in the same direction
  long euler_characteristic = 0;          ///< vertices - edges + triangles
};

/// Whether the triangle goes from the edge's first vertex to its second, and not the other way.
bool runs_along(const Triangle& t, const Edge& edge);

Topology measure_topology(const Mesh& mesh, const Adjacency& adjacency);

}  // namespace taut::sim
