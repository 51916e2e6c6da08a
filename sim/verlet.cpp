#include "sim/verlet.hpp"

#include <cassert>

namespace taut::sim {

void predict_positions(std::span<const Vec3> previous, std::span<const Vec3> current,
                       std::span<const Vec3> forces_n, std::span<const double> inverse_masses_per_kg,
                       double time_step_s, std::span<Vec3> predicted) {
  const std::size_t n = current.size();
  assert(previous.size() == n && forces_n.size() == n && inverse_masses_per_kg.size() == n);
  assert(predicted.size() == n);
  const double dt_squared = time_step_s * time_step_s;
  for (std::size_t v = 0; v < n; ++v) {
    if (inverse_masses_per_kg[v] == 0.0) {
      predicted[v] = current[v];
      continue;
    }
    const Vec3 acceleration = forces_n[v] * inverse_masses_per_kg[v];
    // Adding the small difference loses fewer digits than 2 p(t) - p(t - dt).
    predicted[v] = current[v] + ((current[v] - previous[v]) + acceleration * dt_squared);
  }
}

}  // namespace taut::sim
