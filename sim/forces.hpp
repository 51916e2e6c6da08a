#pragma once

#include <span>
#include <vector>

#include "sim/garment.hpp"
#include "sim/hand.hpp"
#include "sim/rigid_motion.hpp"
#include "sim/state.hpp"
#include "sim/wind.hpp"

namespace taut::sim {

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

/// The three functions below add to `forces_n`, in newtons, one entry per vertex of the garment.
void add_gravity(const Garment& garment, const Vec3& gravity_m_per_s2, std::span<Vec3> forces_n);
/// The force on a vertex is -mass * air_drag_per_s * velocity.
void add_air_drag(const Garment& garment, const State& state, double air_drag_per_s,
                  std::span<Vec3> forces_n);
/// Requires that the vertex of every force exists (require_possible checks it).
void add_artificial_forces(std::span<const PointForce> artificial, std::span<Vec3> forces_n);

/// Adds all external forces: gravity, wind, air drag, artificial forces and the forces of hands.
/// `time_step_s` is the step in which the forces will act; wind and hands need it to stay stable. Requires
/// that the vertices of forces and hands exist (require_possible checks it).
void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external,
                         double time_step_s, std::span<Vec3> forces_n);

}  // namespace taut::sim
