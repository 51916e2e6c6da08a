#include "sim/solvers/provot.hpp"

#include <glm/geometric.hpp>

#include "sim/strong_constraint.hpp"

namespace taut::sim {

void ProvotThreshold::compensate(const Garment& garment, const Pins& pins, State& state) const {
  const Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.begin_of(SpringKind::flexural); ++s) {
    const auto [i, j] = springs.ends[s];
    const Vec3 spring = state.predicted[i] - state.predicted[j];
    const double length_m = glm::length(spring);
    const double error_m = length_m - (1.0 + max_stretch_) * springs.rest_lengths_m[s];
    if (error_m > 0.0) {
      compensate_spring(springs.ends[s], spring, length_m, error_m, pins.inverse_masses_per_kg,
                        state.predicted);
    }
  }
}

}  // namespace taut::sim
