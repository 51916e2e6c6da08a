#pragma once

#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// How a surface is connected. Positions do not matter.
struct Topology {
  std::size_t components = 0;             ///< connected parts
  std::size_t boundary_edges = 0;         ///< edges with one triangle
  std::size_t boundary_loops = 0;         ///< connected runs of boundary edges
  std::size_t non_manifold_edges = 0;     ///< edges with more than two triangles
  std::size_t non_manifold_vertices = 0;  ///< vertices whose triangles form more than one fan
  std::size_t misoriented_edges = 0;      ///< edges whose two triangles face different sides
  long euler_characteristic = 0;          ///< vertices - edges + triangles
};

/// Returns whether the triangle goes from the edge's first vertex to its second. False if it goes the other
/// way.
bool runs_along(const Triangle& t, const Edge& edge);

/// Returns whether the edge has two triangles, which face different sides. Requires the adjacency of this mesh.
bool is_misoriented(const Mesh& mesh, const Adjacency& adjacency, std::size_t edge);

/// Requires the adjacency of this mesh.
Topology measure_topology(const Mesh& mesh, const Adjacency& adjacency);

/// Returns the first vertex of each connected part of a surface, ascending. Vertices without triangles are no
/// part of it. Requires triangles of vertices below `vertex_count`.
std::vector<Index> first_vertices_of_parts(std::size_t vertex_count, std::span<const Triangle> triangles);

/// Turns triangles until both triangles of every edge face the same side. Of each connected part it turns the
/// smaller number. On a surface with one side only, such as a Moebius strip, some neighbours still disagree.
/// Returns how many triangles were turned.
std::size_t orient_consistently(Mesh& mesh);

}  // namespace taut::sim
