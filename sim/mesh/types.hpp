#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace taut::sim {

using Vec3 = glm::dvec3;
using Index = std::uint32_t;

/// Two vertices, the smaller index first.
using Edge = std::array<Index, 2>;
/// Counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;
/// Counter-clockwise seen from outside.
using Quad = std::array<Index, 4>;

}  // namespace taut::sim
