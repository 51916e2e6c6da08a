#pragma once

#include <cstddef>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::tailor {

/// Counts the pairs of an edge and a triangle, without a common vertex, where the edge passes through the
/// triangle. 0 means that the surface does not intersect itself.
std::size_t count_crossings(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

}  // namespace taut::tailor
