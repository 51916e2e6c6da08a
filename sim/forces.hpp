#pragma once

#include <span>
#include <vector>

#include "sim/garment.hpp"
#include "sim/hand.hpp"
#include "sim/state.hpp"
#include "sim/wind.hpp"

namespace taut::sim {

/// The paper's artificial force: a force on one vertex, such as a hand's pull.
struct PointForce {
  Index vertex = 0;
  Vec3 force_n = {0.0, 0.0, 0.0};

  bool operator==(const PointForce&) const = default;
};

/// The external forces of Step 2.
struct ExternalForces {
  Vec3 gravity_m_per_s2 = {0.0, -9.81, 0.0};
  Wind wind;
  /// The rate at which the air slows every vertex down, per second. More comes to rest sooner and swings
  /// less.
  double air_drag_per_s = 1.5;
  std::vector<PointForce> artificial_forces;
  std::vector<HeldVertex> held_vertices;

  bool operator==(const ExternalForces&) const = default;
};

void add_gravity(const Garment& garment, const Vec3& gravity_m_per_s2, std::span<Vec3> forces_n);
void add_air_drag(const Garment& garment, const State& state, double air_drag_per_s,
                  std::span<Vec3> forces_n);
/// Every force must be on a vertex that is there: see require_possible.
void add_artificial_forces(std::span<const PointForce> artificial, std::span<Vec3> forces_n);

/// All of the above and the wind.
void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external,
                         double time_step_s, std::span<Vec3> forces_n);

}  // namespace taut::sim
