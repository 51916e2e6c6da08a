#pragma once

#include "prelude.hpp"

namespace taut::sim {

/// A direction in a plane.
using Vec2 = glm::dvec2;
/// A position, direction or other vector of three components.
using Vec3 = glm::dvec3;
/// Index of a vertex, edge, triangle or spring, from 0.
using Index = std::uint32_t;

/// Vertices of an edge or spring, the smaller index first.
using Edge = std::array<Index, 2>;
/// Vertices counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;
/// Vertices counter-clockwise seen from outside.
using Quad = std::array<Index, 4>;

}  // namespace taut::sim
