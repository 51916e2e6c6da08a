#pragma once

#include "sim/rigid_motion.hpp"
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

/// The wind. The paper's "wind value" is the speed in m/s.
struct Wind {
  double speed_m_per_s = 0.0;
  Vec3 direction = {0.0, 0.0, -1.0};  ///< where the air goes; any length
  /// How much gusts raise and lower the speed, as a fraction of it. At 0 the speed is steady.
  double gust_amplitude = 0.0;
  double gust_period_s = 1.0;  ///< the mean time from one gust to the next; above 0
  /// How far gusts turn the wind sideways, as the tangent of the angle.
  double gust_turn = 0.0;
  /// The same seed gives the same gusts.
  std::uint64_t gust_seed = 1;
  /// The coefficient C_n of the pressure on a face that the air meets at right angles; about 1.2 for a flat
  /// plate.
  double pressure_coefficient = 1.2;
  /// The coefficient C_t of the friction of air that flows along a face.
  double friction_coefficient = 0.05;

  bool operator==(const Wind&) const = default;
};

/// The rho of add_wind_forces.
inline constexpr double air_density_kg_per_m3 = 1.2;

/// Returns the velocity of the air at a time, with gusts, in m/s.
Vec3 wind_velocity(const Wind& wind, double time_s);

/// Adds the force of the air on every triangle to `forces_n`, in newtons, one entry per vertex of the
/// garment. Each corner gets one third. Still air brakes the cloth. With the air's velocity u relative to the
/// triangle, its normal part u_n and its tangential part u_t:
///   F = 1/2 rho A (C_n |u_n| u_n + C_t |u| u_t)
/// (quadratic drag as in Keckeisen, Kimmerle, Thomaszewski and Wacker 2004). A light triangle would take on
/// more than the air's velocity within one step. The factor 1 / (1 + dt F' / m) prevents that. It holds for cloth that
/// air alone moves; the longer the step, the less presses on what pins hold (see SlowForces for a law without that).
void add_wind_forces(const Garment& garment, const State& state, const Wind& wind, double time_step_s,
                     std::span<Vec3> forces_n);

/// The paper's artificial force on one vertex, in newtons.
struct PointForce {
  Index vertex = 0;
  Vec3 force_n = {0.0, 0.0, 0.0};

  bool operator==(const PointForce&) const = default;
};

/// The external forces of Step 2 of the paper.
struct ExternalForces {
  Vec3 gravity_m_per_s2 = {0.0, -9.81, 0.0};
  std::vector<PathPoint> gravity_path = {};  ///< what is added to gravity over time, in m/s^2
  Wind wind;
  /// The air slows every vertex by this rate, per second; at least 0. A larger rate brings the cloth to rest
  /// sooner and makes it swing less.
  double air_drag_per_s = 1.5;
  std::vector<PointForce> artificial_forces;
  /// The vertices that hands hold.
  std::vector<HeldVertex> held_vertices;

  bool operator==(const ExternalForces&) const = default;
};

/// Returns the gravity at this time, in m/s^2.
Vec3 gravity_at(const ExternalForces& external, double time_s);
/// Returns the largest that it is at any time, in m/s^2.
double largest_gravity_m_per_s2(const ExternalForces& external);

/// Adds all external forces: gravity, wind, air drag, artificial forces and the forces of hands.
/// `time_step_s` is the step in which the forces will act; wind and hands need it to stay stable. Requires
/// that the vertices of forces and hands exist (require_possible checks it).
void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external, double time_step_s,
                         std::span<Vec3> forces_n);

}  // namespace taut::sim
