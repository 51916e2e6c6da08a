#pragma once

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/groups.hpp"

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

/// Returns which corner of the triangle the vertex is. Requires that it is one.
inline Index corner_at(const Triangle& t, Index vertex) { return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2; }

/// Returns groups of corners, a group for each fan: triangles at a vertex that are connected through edges. Corner
/// 3t + k is corner k of triangle t. Requires the adjacency of these triangles.
Groups fans_of(std::span<const Triangle> triangles, const Adjacency& adjacency);

/// Two triangles that are neighbours at an edge.
struct Joint {
  Edge edge;
  Index a, b;
  bool run_alike;  ///< both run along the edge the same way: they face different sides
};

/// Returns, per triangle, 1 if it is to be turned so that neighbours face the same side. Of each connected part it is
/// the smaller number. On a surface with one side only some neighbours still disagree.
std::vector<char> turns_to_agree(std::size_t triangle_count, std::span<const Joint> joints);

/// Turns triangles until both triangles of every edge face the same side. Of each connected part it turns the
/// smaller number. On a surface with one side only, such as a Moebius strip, some neighbours still disagree.
/// Returns how many triangles were turned.
std::size_t orient_consistently(Mesh& mesh);

}  // namespace taut::sim
