#include "sim/hand.hpp"

namespace taut::sim {

Vec3 hand_force(const HeldVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double time_step_s) {
  const double k = held.stiffness_n_per_m;
  const double c = 2.0 * std::sqrt(k * mass_kg);
  const Vec3 pull = k * (held.point_m - position_m - time_step_s * velocity_m_per_s) - c * velocity_m_per_s;
  const Vec3 force = pull / (1.0 + time_step_s * (c + time_step_s * k) / mass_kg);
  const double size = glm::length(force);
  return size > held.max_force_n ? force * (held.max_force_n / size) : force;
}

void add_hand_forces(const Garment& garment, const State& state, std::span<const HeldVertex> held, double time_step_s,
                     std::span<Vec3> forces_n) {
  for (const HeldVertex& h : held) {
    assert(h.vertex < forces_n.size());
    const double mass_kg = garment.masses_kg[h.vertex];
    if (mass_kg > 0.0) {
      forces_n[h.vertex] += hand_force(h, mass_kg, state.current[h.vertex], velocity(state, h.vertex), time_step_s);
    }
  }
}

}  // namespace taut::sim
