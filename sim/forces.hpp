#pragma once

#include "sim/rigid_motion.hpp"
#include "sim/state.hpp"
#include "sim/wind.hpp"

namespace taut::sim {

/// A vertex grabbed by a hand: a spring pulls it to the hand's point. The damping is critical for the mass of this one
/// vertex.
struct GrabbedVertex {
  Index vertex = 0;
  /// Position of the hand.
  Vec3 point_m = {0.0, 0.0, 0.0};
  /// Stiffness of the hand's spring.
  double stiffness_n_per_m = 0.0;
  /// Largest force of the hand. Beyond it the hand slips, so that it does not tear the cloth.
  double max_force_n = 0.0;

  bool operator==(const GrabbedVertex&) const = default;
};

/// Returns the force in newtons of a hand on a vertex of mass m = `mass_kg`, which must be above 0. With the vector d
/// from the vertex to the hand's point, the velocity v and the time step dt:
///   f = (k (d - dt v) - c v) / (1 + dt c / m + dt^2 k / m),   c = 2 sqrt(k m),
/// limited to `max_force_n`. The divisor belongs to one implicit step of dt with a constant force (Baraff and Witkin
/// 1998, for a single vertex). It prevents a stiff spring from throwing a light vertex about.
Vec3 hand_force(const GrabbedVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double time_step_s);

/// Adds the forces of hands to `forces_n`, in newtons, one entry per vertex of the garment. Vertices without mass are
/// skipped. Requires that the grabbed vertices exist (require_possible checks it).
void add_hand_forces(const Garment& garment, const State& state, std::span<const GrabbedVertex> held,
                     double time_step_s, std::span<Vec3> forces_n);

/// Density rho of the air in add_wind_forces.
inline constexpr double air_density_kg_per_m3 = 1.2;

/// Adds the force of the air on every triangle to `forces_n`, in newtons, one entry per vertex of the garment. Each
/// corner gets one third. Still air brakes the cloth. With the air velocity u relative to the triangle, its normal part
/// u_n and its tangential part u_t:
///   F = 1/2 rho A |u| (C_n k u_n + C_t u_t),   k = (4 + pi) / (4 + pi s),   s = |u_n| / |u|
/// C_n k s is the normal force of a flat plate at the angle of incidence asin s (Rayleigh 1876, after Kirchhoff 1869),
/// scaled to C_n at a right angle. In one explicit step a light triangle would gain more than the air's velocity. The
/// factors 1 / (1 + dt F' / m) prevent that, F' being the derivative of the normal force by |u_n|,
///   F' = 1/2 rho A |u| C_n k (4 + 4 s^2 + 2 pi s^3) / (4 + pi s),
/// or 2 C_t |u| of the friction. They are those of one linearised implicit step for cloth that air alone moves; longer
/// steps underestimate the pressure on pinned cloth (SlowForces does not). `fractions`: see
/// find_wind_fractions. Without them the wind of the origin blows everywhere.
void add_wind_forces(const Garment& garment, const State& state, const Wind& wind, std::span<const float> fractions,
                     double time_step_s, std::span<Vec3> forces_n);

/// The paper's artificial force on one vertex, in newtons.
struct PointForce {
  Index vertex = 0;
  Vec3 force_n = {0.0, 0.0, 0.0};

  bool operator==(const PointForce&) const = default;
};

/// The external forces of Step 2 of the paper.
struct ExternalForces {
  Vec3 gravity_m_per_s2 = {0.0, -9.81, 0.0};
  std::vector<PathPoint> gravity_path = {};  ///< change of gravity over time, in m/s^2
  Wind wind;
  /// Rate at which air slows every vertex, per second; at least 0. Larger rates let the cloth rest sooner and swing
  /// less.
  double air_drag_per_s = 1.5;
  std::vector<PointForce> artificial_forces;
  std::vector<GrabbedVertex> grabbed_vertices;

  bool operator==(const ExternalForces&) const = default;
};

/// Returns gravity at this time, in m/s^2.
Vec3 gravity_at(const ExternalForces& external, double time_s);
/// Returns the largest magnitude of gravity at any time, in m/s^2.
double max_gravity_m_per_s2(const ExternalForces& external);

/// Adds all external forces: gravity, wind, air drag, artificial forces and the forces of hands. `time_step_s` is the
/// duration for which the forces will act; wind and hands need it to stay stable. Requires that the vertices of forces
/// and hands exist (require_possible checks it). `wind_fractions`: see find_wind_fractions.
void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external,
                         std::span<const float> wind_fractions, double time_step_s, std::span<Vec3> forces_n);

}  // namespace taut::sim
