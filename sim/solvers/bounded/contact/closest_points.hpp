#pragma once

#include "prelude.hpp"

namespace taut::sim::bounded {

/// Weights of the corners at the closest points of two primitives; each primitive's add up to 1. A vertex and a
/// triangle: {1, b0, b1, b2}. Two edges: {a0, a1, b0, b1}.
using ClosestWeights = std::array<float, 4>;

/// Returns the closest points of the point p[0] and the triangle of the other three.
ClosestWeights closest_vertex_triangle(const std::array<glm::vec3, 4>& p);

/// Returns the closest points of the segments from p[0] to p[1] and from p[2] to p[3].
ClosestWeights closest_edges(const std::array<glm::vec3, 4>& p);

}  // namespace taut::sim::bounded
