#include "sim/solvers/ideal.hpp"

#include <array>
#include <glm/geometric.hpp>

namespace taut::sim {

double stiffness_of(SpringKind kind, const SpringStiffness& stiffness) {
  return std::array{stiffness.structural_n_per_m, stiffness.shear_n_per_m,
                    stiffness.flexural_n_per_m}[static_cast<std::size_t>(kind)];
}

void IdealSprings::add_spring_forces(const Garment& garment, const State& state,
                                     std::span<Vec3> forces_n) const {
  const Springs& springs = garment.springs;
  for (const SpringKind kind : all_spring_kinds) {
    const double stiffness = stiffness_of(kind, stiffness_);
    for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
      const auto [i, j] = springs.ends[s];
      const Vec3 spring = state.current[i] - state.current[j];
      const double length = glm::length(spring);
      if (!(length > 0.0)) {
        continue;
      }
      const Vec3 direction = spring / length;
      const double closing_speed = glm::dot(velocity(state, i) - velocity(state, j), direction);
      const Vec3 pull = direction * (stiffness * (length - springs.rest_lengths_m[s]) +
                                     stiffness_.damping_n_s_per_m * closing_speed);
      forces_n[i] -= pull;
      forces_n[j] += pull;
    }
  }
}

}  // namespace taut::sim
