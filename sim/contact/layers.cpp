#include "sim/contact/layers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::sim {

std::optional<Parted> part(const LayerParting& law, const Vec3& between_m, const Vec3& moved_m,
                           double inverse_mass_sum_per_kg) {
  const double squared_m2 = glm::dot(between_m, between_m);
  if (!(squared_m2 < law.distance_m * law.distance_m) || !(squared_m2 > 0.0) ||
      !(inverse_mass_sum_per_kg > 0.0)) {
    return {};
  }
  const double length_m = std::sqrt(squared_m2);
  const double lacking_m = law.share_at_once * (law.distance_m - length_m);
  const Vec3 current = between_m * (lacking_m / (length_m * inverse_mass_sum_per_kg));
  if (law.gives_speed) {
    return Parted{current, Vec3(0.0)};
  }
  const double approach =
      std::min(glm::dot(moved_m, between_m), 0.0) / (squared_m2 * inverse_mass_sum_per_kg);
  return Parted{current, current + between_m * approach};
}

void part_layers(std::span<const Edge> pairs, double distance_m,
                 std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted) {
  assert(inverse_masses_per_kg.size() == predicted.size());
  const LayerParting at_once = {distance_m};
  for (const auto& [i, j] : pairs) {
    const double w_i = inverse_masses_per_kg[i];
    const double w_j = inverse_masses_per_kg[j];
    if (const auto parted = part(at_once, predicted[i] - predicted[j], Vec3(0.0), w_i + w_j)) {
      predicted[i] += w_i * parted->current;
      predicted[j] -= w_j * parted->current;
    }
  }
}

}  // namespace taut::sim
