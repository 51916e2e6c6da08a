#include "sim/solvers/explicit_solvers.hpp"

namespace taut::sim {
namespace {

struct Share {
  double when_long;
  double when_short;
};

Share correction_share(SpringKind kind, const Rigidity& rigidity) {
  if (kind == SpringKind::flexural) return {rigidity.flexural, rigidity.flexural};
  return {1.0, rigidity.compression};
}

// Fraction of the longest stable step to use. Wind adds up to 1 to the left side of the inequality and a hand less; at
// this value they may add 1.2. Larger values leave less for them.
constexpr double stable_step_fraction = 0.7;

}  // namespace

void compensate_springs(const Springs& springs, std::span<const double> inverse_masses_per_kg, const Rigidity& rigidity,
                        std::span<Vec3> predicted) {
  assert(inverse_masses_per_kg.size() == predicted.size());
  for (const SpringKind kind : all_spring_kinds) {
    const Share share = correction_share(kind, rigidity);
    for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
      const auto [i, j] = springs.ends[s];
      const Vec3 spring = predicted[i] - predicted[j];
      const double length_m = glm::length(spring);
      const double error_m = length_m - springs.rest_lengths_m[s];
      const double fraction = error_m > 0.0 ? share.when_long : share.when_short;
      compensate_spring(springs.ends[s], spring, length_m, fraction * error_m, inverse_masses_per_kg, predicted);
    }
  }
}

double spring_stiffness(SpringKind kind, const SpringStiffness& stiffness) {
  return std::array{stiffness.structural_n_per_m, stiffness.shear_n_per_m,
                    stiffness.flexural_n_per_m}[static_cast<std::size_t>(kind)];
}

void IdealSprings::add_spring_forces(const Garment& garment, const State& state, std::span<Vec3> forces_n) const {
  assert(forces_n.size() == state.current.size());
  const Springs& springs = garment.springs;
  for (const SpringKind kind : all_spring_kinds) {
    const double stiffness = spring_stiffness(kind, stiffness_);
    for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
      const auto [i, j] = springs.ends[s];
      const Vec3 spring = state.current[i] - state.current[j];
      const double length = glm::length(spring);
      if (!(length > 0.0)) continue;
      const Vec3 direction = spring / length;
      const double closing_speed = glm::dot(velocity(state, i) - velocity(state, j), direction);
      const Vec3 pull =
          direction * (stiffness * (length - springs.rest_lengths_m[s]) + stiffness_.damping_n_s_per_m * closing_speed);
      forces_n[i] -= pull;
      forces_n[j] += pull;
    }
  }
}

void StrongConstraint::compensate(const Garment& garment, const Pins& pins, State& state) const {
  for (int iteration = 0; iteration < settings_.iterations; ++iteration) {
    compensate_springs(garment.springs, pins.inverse_masses_per_kg, settings_.rigidity, state.predicted);
  }
}

void ProvotThreshold::compensate(const Garment& garment, const Pins& pins, State& state) const {
  const Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.begin_index(SpringKind::flexural); ++s) {
    const auto [i, j] = springs.ends[s];
    const Vec3 spring = state.predicted[i] - state.predicted[j];
    const double length_m = glm::length(spring);
    const double error_m = length_m - (1.0 + max_stretch_) * springs.rest_lengths_m[s];
    if (error_m > 0.0) {
      compensate_spring(springs.ends[s], spring, length_m, error_m, pins.inverse_masses_per_kg, state.predicted);
    }
  }
}

void VelocityModification::compensate(const Garment& garment, const Pins& pins, State& state) const {
  const Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.begin_index(SpringKind::flexural); ++s) {
    const auto [i, j] = springs.ends[s];
    const Vec3 spring = state.current[i] - state.current[j];
    const double length_m = glm::length(spring);
    if (!(length_m > (1.0 + max_stretch_) * springs.rest_lengths_m[s])) continue;
    // Verlet's velocities, not divided by the time step.
    const Vec3 moved_i = state.predicted[i] - state.current[i];
    const Vec3 moved_j = state.predicted[j] - state.current[j];
    const double parting_m = glm::dot(moved_i - moved_j, spring) / length_m;
    if (parting_m > 0.0) {
      compensate_spring(springs.ends[s], spring, length_m, parting_m, pins.inverse_masses_per_kg, state.predicted);
    }
  }
}

double stable_time_step_s(const Garment& garment, const Pins& pins, const SpringStiffness& stiffness,
                          double air_drag_per_s) {
  assert(air_drag_per_s >= 0.0);
  const Springs& springs = garment.springs;
  std::vector<double> stiffness_about(garment.masses_kg.size(), 0.0);
  std::vector<double> springs_about(garment.masses_kg.size(), 0.0);
  for (const SpringKind kind : all_spring_kinds) {
    for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
      for (const Index end : springs.ends[s]) {
        stiffness_about[end] += spring_stiffness(kind, stiffness);
        springs_about[end] += 1.0;
      }
    }
  }
  double w_squared = 0.0, c = air_drag_per_s;
  for (std::size_t v = 0; v < stiffness_about.size(); ++v) {
    const double inverse_mass = pins.inverse_masses_per_kg[v];
    w_squared = std::max(w_squared, 2.0 * stiffness_about[v] * inverse_mass);
    c = std::max(c, air_drag_per_s + 2.0 * stiffness.damping_n_s_per_m * springs_about[v] * inverse_mass);
  }
  const double root = c + std::sqrt(c * c + 4.0 * w_squared);
  return root > 0.0 ? stable_step_fraction * 4.0 / root : std::numeric_limits<double>::infinity();
}

}  // namespace taut::sim
