#pragma once

#include "sim/state.hpp"

namespace taut::sim {

/// A vertex that a hand holds: a spring pulls the vertex to the hand's point. The spring is damped critically
/// for the mass of this one vertex.
struct HeldVertex {
  Index vertex = 0;
  /// Where the hand is.
  Vec3 point_m = {0.0, 0.0, 0.0};
  /// The stiffness of the spring.
  double stiffness_n_per_m = 0.0;
  /// The largest force of the hand. A hand slips before it tears the cloth.
  double max_force_n = 0.0;

  bool operator==(const HeldVertex&) const = default;
};

/// Returns the force, in newtons, of a hand on a vertex of mass m = `mass_kg`, which must be above 0. With
/// the vector d from the vertex to the hand's point, the velocity v and the time step dt:
///   f = (k (d - dt v) - c v) / (1 + dt c / m + dt^2 k / m),   c = 2 sqrt(k m),
/// limited to `max_force_n`. The divisor is that of one implicit step of dt in which the force stays constant
/// (Baraff and Witkin 1998, for a single vertex). It keeps a stiff spring from throwing a light vertex about.
Vec3 hand_force(const HeldVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double time_step_s);

/// Adds the forces of hands to `forces_n`, in newtons, one entry per vertex of the garment. Vertices without
/// mass are skipped. Requires that the held vertices exist (require_possible checks it).
void add_hand_forces(const Garment& garment, const State& state, std::span<const HeldVertex> held, double time_step_s,
                     std::span<Vec3> forces_n);

}  // namespace taut::sim
