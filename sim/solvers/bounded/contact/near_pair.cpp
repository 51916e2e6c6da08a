#include "sim/solvers/bounded/contact/near_pair.hpp"

namespace taut::sim::bounded {

ClosestWeights closest_weights(const NearPair& pair, const std::array<glm::vec3, 4>& p) {
  if (pair.first_count == 2) return closest_edges(p);
  if (pair.first_count == 1) return closest_vertex_triangle(p);
  const ClosestWeights w = closest_vertex_triangle({p[3], p[0], p[1], p[2]});
  return {w[1], w[2], w[3], w[0]};
}

// Relative to the first corner: differences of near numbers are exact.
glm::vec3 between_closest(const NearPair& pair, const std::array<glm::vec3, 4>& p, const ClosestWeights& weights) {
  glm::vec3 between(0.0F);
  for (Index k = 0; k < 4; ++k) between += (k < pair.first_count ? weights[k] : -weights[k]) * (p[k] - p[0]);
  return between;
}

float distance_between(const NearPair& pair, const std::array<glm::vec3, 4>& p) {
  return glm::length(between_closest(pair, p, closest_weights(pair, p)));
}

}  // namespace taut::sim::bounded
