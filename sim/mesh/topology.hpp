#pragma once

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Connectivity of a surface; positions do not matter.
struct Topology {
  std::size_t components = 0;             ///< connected parts
  std::size_t boundary_edges = 0;         ///< edges with one triangle
  std::size_t boundary_loops = 0;         ///< connected runs of boundary edges
  std::size_t non_manifold_edges = 0;     ///< edges with more than two triangles
  std::size_t non_manifold_vertices = 0;  ///< vertices whose triangles form more than one fan
  std::size_t misoriented_edges = 0;      ///< edges whose two triangles face different sides
  long euler_characteristic = 0;          ///< vertices - edges + triangles
};

/// Returns whether the triangle traverses the edge from its first to its second vertex.
bool runs_along(const Triangle& t, const Edge& edge);

/// Returns whether the edge has exactly two triangles and they face different sides. Requires the adjacency of this
/// mesh.
bool is_misoriented(const Mesh& mesh, const Adjacency& adjacency, std::size_t edge);

/// Requires the adjacency of this mesh.
Topology measure_topology(const Mesh& mesh, const Adjacency& adjacency);

/// Returns the first vertex of each connected part of a surface, ascending. Vertices without triangles are ignored.
/// Requires triangles of vertices below `vertex_count`.
std::vector<Index> first_vertices_of_parts(std::size_t vertex_count, std::span<const Triangle> triangles);

/// Returns the corner number, 0 to 2, of a vertex of the triangle.
inline Index corner_at(const Triangle& t, Index vertex) { return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2; }

/// Returns one group of corners for each fan: the triangles at a vertex that are connected through edges. Corner 3t + k
/// is corner k of triangle t. Requires the adjacency of these triangles.
Groups find_fans(std::span<const Triangle> triangles, const Adjacency& adjacency);

/// Two triangles that are neighbours at an edge.
struct Joint {
  Edge edge;
  Index a, b;
  bool run_alike;  ///< the triangles traverse the edge the same way: they face different sides
};

/// Returns, per triangle, 1 if it has to be turned for neighbours to face the same side. In each connected part the
/// smaller number is turned. On a one-sided surface some neighbours still disagree.
std::vector<char> turns_to_agree(std::size_t triangle_count, std::span<const Joint> joints);

/// Turns triangles until both triangles of every edge face the same side. In each connected part it turns the smaller
/// number. On a one-sided surface, such as a Moebius strip, some neighbours still disagree. Returns the number of
/// turned triangles.
std::size_t orient_consistently(Mesh& mesh);

/// Returns the number of times that a closed surface facing outwards winds around the point: 1 inside, 0 outside, up to
/// rounding. The solid angles of its triangles are added up (Van Oosterom and Strackee 1983), in time proportional to
/// their number. Requires a point that is not on the surface.
double winding_number(const Vec3& point_m, const Surface& surface);

}  // namespace taut::sim
