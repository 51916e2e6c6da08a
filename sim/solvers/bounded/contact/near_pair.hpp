#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/contact/closest_points.hpp"

namespace taut::sim::bounded {

/// Pair of a vertex and a triangle or of two edges, without a common vertex, or of a triangle and a point of a body.
struct NearPair {
  std::array<Index, 4> rows;
  /// Number of `rows` entries of the first primitive; the others are the second's. 1: vertex and triangle; 2: two
  /// edges; 3: triangle and point.
  Index first_count;

  bool operator==(const NearPair&) const = default;
};

/// Returns the closest points for these positions of the corners.
ClosestWeights closest_weights(const NearPair& pair, const std::array<glm::vec3, 4>& positions);

/// Returns the vector from the second primitive to the first at the closest points.
glm::vec3 between_closest(const NearPair& pair, const std::array<glm::vec3, 4>& positions,
                          const ClosestWeights& weights);

/// Returns the smallest distance of the two primitives.
float distance_between(const NearPair& pair, const std::array<glm::vec3, 4>& positions);

}  // namespace taut::sim::bounded
