#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// In place of a vertex: there is none.
inline constexpr Index no_vertex = std::numeric_limits<Index>::max();

/// As of sim/mesh/mesh.hpp. Fills `kept` with the vertex of the result that stands for each vertex of
/// `input`, or `no_vertex` where it belongs to no triangle, or only to some that were dropped.
ValidatedMesh weld_and_validate(const Mesh& input, const RepairSettings& settings, std::vector<Index>& kept);

/// Of each vertex whether a triangle uses it.
std::vector<char> used_vertices(const Mesh& mesh);

/// For each vertex the first vertex at exactly the same position; -0 equals +0.
std::vector<Index> first_at_same_position(const std::vector<Vec3>& positions);

/// For each vertex of `mesh` the vertex that takes its place. Vertices at one place (see
/// `first_at_same_position`) become one, but for those around which the triangles close by themselves: these
/// are layers that touch.
std::vector<Index> weld_at_places(const Mesh& mesh, const std::vector<Index>& places);

/// Joins border vertices of the mesh as `welded` makes it where they are nearer to each other than the
/// distance, in metres, also through others between them. Returns how many more vertices were welded.
std::size_t weld_near_borders(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

}  // namespace taut::sim
