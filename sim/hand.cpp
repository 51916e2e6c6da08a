#include "sim/hand.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

namespace taut::sim {

void add_hand_forces(const Garment& garment, const State& state, std::span<const HeldVertex> held,
                     double time_step_s, std::span<Vec3> forces_n) {
  for (const HeldVertex& h : held) {
    if (h.vertex >= forces_n.size()) {
      throw std::invalid_argument("a hand holds vertex " + std::to_string(h.vertex) +
                                  ", but there are only " + std::to_string(forces_n.size()));
    }
    const double mass_kg = garment.masses_kg[h.vertex];
    if (!(mass_kg > 0.0)) {
      continue;
    }
    const double k = h.stiffness_n_per_m;
    const double c = 2.0 * std::sqrt(k * mass_kg);
    const Vec3 v = velocity(state, h.vertex);
    const Vec3 pull = k * (h.point_m - state.current[h.vertex] - time_step_s * v) - c * v;
    const Vec3 force = pull / (1.0 + time_step_s * (c + time_step_s * k) / mass_kg);
    const double size = glm::length(force);
    forces_n[h.vertex] += size > h.max_force_n ? force * (h.max_force_n / size) : force;
  }
}

}  // namespace taut::sim
