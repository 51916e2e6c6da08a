#include "sim/solvers/vassilev/vassilev.hpp"

#include <glm/geometric.hpp>

#include "sim/strong_constraint.hpp"

namespace taut::sim {

void VelocityModification::compensate(const Garment& garment, const Pins& pins, State& state) const {
  const Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.begin_of(SpringKind::flexural); ++s) {
    const auto [i, j] = springs.ends[s];
    const Vec3 spring = state.current[i] - state.current[j];
    const double length_m = glm::length(spring);
    if (!(length_m > (1.0 + max_stretch_) * springs.rest_lengths_m[s])) {
      continue;
    }
    // Velocities times the time step: without it, as Verlet has them.
    const Vec3 moved_i = state.predicted[i] - state.current[i];
    const Vec3 moved_j = state.predicted[j] - state.current[j];
    const double parting_m = glm::dot(moved_i - moved_j, spring) / length_m;
    if (parting_m > 0.0) {
      compensate_spring(springs.ends[s], spring, length_m, parting_m, pins.inverse_masses_per_kg,
                        state.predicted);
    }
  }
}

}  // namespace taut::sim
