#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Joins borders that run along each other within a distance while the cloth goes different ways from them,
/// whether or not their vertices match: each vertex is welded to the nearest place of the other border.
/// Returns how many vertices were. Where more than two triangles meet after that, it is for `cut_into_sheets`
/// to choose. Requires edges with two triangles at most.
std::size_t join_borders(double distance_m, sim::Mesh& mesh);

/// Joins parts that lie farther apart, where along most of a border another part goes on beyond the gap, as
/// trousers do below their waistband. Places that are joined are at least `spacing_m` apart. Returns and
/// requires the same.
std::size_t join_parts(double gap_m, double spacing_m, sim::Mesh& mesh);

/// Closes holes whose border is shorter than this. Returns how many.
std::size_t fill_small_holes(double longest_m, sim::Mesh& mesh);

/// Closed border lines: vertices in order, the cloth on the left of the way as seen from outside.
std::vector<std::vector<sim::Index>> border_loops(const sim::Mesh& mesh);

}  // namespace taut::app
