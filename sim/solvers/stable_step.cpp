#include "sim/solvers/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::sim {
namespace {

// The fraction of the longest stable step that is used. Wind adds up to 1 to the left side of the inequality
// and a hand less. With this value they may add 1.2. A larger value leaves less for them.
constexpr double share_of_limit = 0.7;

}  // namespace

double stable_time_step_s(const Garment& garment, const Pins& pins, const SpringStiffness& stiffness,
                          double air_drag_per_s) {
  const Springs& springs = garment.springs;
  std::vector<double> stiffness_about(garment.masses_kg.size(), 0.0);
  std::vector<double> springs_about(garment.masses_kg.size(), 0.0);
  for (const SpringKind kind : all_spring_kinds) {
    for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
      for (const Index end : springs.ends[s]) {
        stiffness_about[end] += stiffness_of(kind, stiffness);
        springs_about[end] += 1.0;
      }
    }
  }
  double w_squared = 0.0;
  double c = air_drag_per_s;
  for (std::size_t v = 0; v < stiffness_about.size(); ++v) {
    const double inverse_mass = pins.inverse_masses_per_kg[v];
    w_squared = std::max(w_squared, 2.0 * stiffness_about[v] * inverse_mass);
    c = std::max(c, air_drag_per_s + 2.0 * stiffness.damping_n_s_per_m * springs_about[v] * inverse_mass);
  }
  const double root = c + std::sqrt(c * c + 4.0 * w_squared);
  return root > 0.0 ? share_of_limit * 4.0 / root : std::numeric_limits<double>::infinity();
}

}  // namespace taut::sim
