#pragma once

#include "sim/mesh/groups.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Marks a missing vertex.
inline constexpr Index no_vertex = std::numeric_limits<Index>::max();

/// Returns the mesh with every triangle corner v replaced by vertices[v].
Mesh renumber_corners(const Mesh& mesh, const std::vector<Index>& vertices);

/// Returns the groups of vertices connected by triangles or by equal positions. Vertices without triangles stay alone.
Groups find_pieces(const Mesh& mesh);

/// Returns, per vertex, 1 if a triangle uses it and 0 if none does.
std::vector<char> used_vertices(const Mesh& mesh);

/// Returns, per vertex, the first vertex at exactly the same position. -0 equals +0.
std::vector<Index> first_at_same_position(const std::vector<Vec3>& positions);

/// Returns, per vertex, the vertex that replaces it. `places` is the result of `first_at_same_position`. Vertices at
/// one position become one, except those surrounded by triangles: these belong to layers that touch.
std::vector<Index> weld_at_places(const Mesh& mesh, const std::vector<Index>& places);

/// Welds border vertices that are closer than `distance_m`, also in chains. `welded` holds, per vertex of `mesh`, the
/// vertex that replaces it; it is read and updated. Returns the number of vertices welded here.
std::size_t weld_near_borders(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

/// Sews parts together at borders closer than `distance_m` if the match is unambiguous: vertices of different parts
/// that are each other's nearest and whose cloth continues in different directions. No two vertices of one part become
/// one, so that no strip is sewn to itself and layers that lie on each other stay apart. `welded` holds, per vertex of
/// `mesh`, the vertex that replaces it; it is read and updated. Returns the number of vertices replaced here.
std::size_t sew_parts(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

}  // namespace taut::sim
