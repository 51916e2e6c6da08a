#pragma once

#include <span>
#include <vector>

#include "sim/garment.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// A vertex that a spring draws to a point. `stiffness` is the spring's; its damping is critical for the
/// vertex alone.
struct HeldVertex {
  Index vertex = 0;
  Vec3 point_m = {0.0, 0.0, 0.0};
  double stiffness_n_per_m = 0.0;
  double max_force_n = 0.0;  ///< more is not pulled: a hand slips rather than tear the cloth

  bool operator==(const HeldVertex&) const = default;
};

/// The artificial force of a hand that has hold of a vertex of that mass (above 0), in N: with the
/// displacement d to its point and the velocity v,
///   f = (k (d - dt v) - c v) / (1 + dt c / m + dt^2 k / m),   c = 2 sqrt(k m),
/// limited to the largest force. The divisor is that of one implicit step of dt, in which the force does not
/// change (Baraff and Witkin 1998, for a single vertex), so that a stiff spring cannot make a light vertex
/// swing up.
Vec3 hand_force(const HeldVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double time_step_s);

/// Adds the forces of hands on vertices that are there: see require_possible. Vertices of no mass are left
/// out.
void add_hand_forces(const Garment& garment, const State& state, std::span<const HeldVertex> held,
                     double time_step_s, std::span<Vec3> forces_n);

}  // namespace taut::sim
