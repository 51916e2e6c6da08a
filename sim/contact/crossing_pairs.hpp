#pragma once

#include "sim/contact/triangle_tree.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Returns all pairs of triangles of the cloth that cross each other (triangle_pair.hpp), ordered by their indices.
std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth);
/// Returns the same. `tree` is one of these triangles at any positions: its making would take most of the time.
std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, TriangleTree tree);
/// Returns those of which a triangle is marked, faster if few are.
std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, TriangleTree tree,
                                              std::span<const std::uint8_t> is_marked);

/// Returns all pairs of a triangle of the cloth and one of the body that cross, in the same order.
std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, const Surface& body);

}  // namespace taut::sim
