#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/contact/closest_points.hpp"

namespace taut::sim::bounded {

/// A vertex and a triangle, or two edges, that share no vertex; or a triangle and a point of a body.
struct NearPair {
  std::array<Index, 4> rows;
  /// How many of the rows are of the first thing, the others are of the second: 1 for a vertex and a
  /// triangle, 2 for two edges, 3 for a triangle and a point.
  Index first_count;

  bool operator==(const NearPair&) const = default;
};

/// Returns where the two things are nearest, for the positions of the rows.
ClosestWeights closest_weights(const NearPair& pair, const std::array<glm::vec3, 4>& positions);

/// Returns the vector from the second thing to the first where they are nearest.
glm::vec3 between_closest(const NearPair& pair, const std::array<glm::vec3, 4>& positions,
                          const ClosestWeights& weights);

/// Returns the direction at right angles to the triangle or to both edges, on the side of `between`. It is
/// what `between` is where the two are nearest at inner points, and certain where that is not.
glm::vec3 normal_across(const NearPair& pair, const std::array<glm::vec3, 4>& positions, const glm::vec3& between);

/// Returns the smallest distance of the two things.
float distance_between(const NearPair& pair, const std::array<glm::vec3, 4>& positions);

}  // namespace taut::sim::bounded
