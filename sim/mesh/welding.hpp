#pragma once

#include "sim/mesh/groups.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Stands for "no vertex".
inline constexpr Index no_vertex = std::numeric_limits<Index>::max();

/// Returns the mesh with every corner of its triangles replaced by what `vertices` holds for it.
Mesh renumbered(const Mesh& mesh, const std::vector<Index>& vertices);

/// Returns groups of vertices that triangles connect, of whatever shares a place. Vertices without triangles belong to
/// none.
Groups pieces_of(const Mesh& mesh);

/// Returns, per vertex, 1 if a triangle uses it and 0 if none does.
std::vector<char> used_vertices(const Mesh& mesh);

/// Returns, per vertex, the first vertex at exactly the same position. -0 equals +0.
std::vector<Index> first_at_same_position(const std::vector<Vec3>& positions);

/// Returns, per vertex, the vertex that replaces it. `places` is what `first_at_same_position` returns.
/// Vertices at one place become one, except those with triangles all around them: these belong to layers that
/// touch.
std::vector<Index> weld_at_places(const Mesh& mesh, const std::vector<Index>& places);

/// Welds border vertices that are closer than `distance_m`, also in chains. `welded` holds, per vertex of
/// `mesh`, the vertex that replaces it; it is read and updated. Returns how many more vertices were welded.
std::size_t weld_near_borders(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

/// Sews parts together where their borders lie closer than `distance_m` and there is no doubt what belongs
/// together: vertices of different parts that are each other's nearest, from where the cloth goes different
/// ways. No two vertices of one part become one, so that no strip is sewn to itself, and layers that lie on
/// each other stay apart. `welded` holds, per vertex of `mesh`, the vertex that replaces it; it is read and
/// updated. Returns how many more vertices were replaced.
std::size_t sew_parts(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

}  // namespace taut::sim
