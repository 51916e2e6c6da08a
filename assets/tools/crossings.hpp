#pragma once

#include <cstddef>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::tailor {

/// How many times an edge passes through a triangle it does not touch: 0 for a surface without
/// self-intersections.
std::size_t count_crossings(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

}  // namespace taut::tailor
