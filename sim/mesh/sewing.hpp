#pragma once

#include <cstddef>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Sews parts together where their borders lie closer than `distance_m` and there is no doubt what belongs
/// together: vertices of different parts that are each other's nearest, from where the cloth goes different
/// ways. No two vertices of one part become one, so that no strip is sewn to itself, and layers that lie on
/// each other stay apart. `welded` holds, per vertex of `mesh`, the vertex that replaces it; it is read and
/// updated. Returns how many more vertices were replaced.
std::size_t sew_parts(double distance_m, const Mesh& mesh, std::vector<Index>& welded);

}  // namespace taut::sim
