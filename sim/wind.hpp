#pragma once

#include <cstdint>
#include <span>

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"
#include "sim/state.hpp"

namespace taut::sim {

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
/// more than the air's velocity within one step. The factor 1 / (1 + dt F' / m) prevents that.
void add_wind_forces(const Garment& garment, const State& state, const Wind& wind, double time_step_s,
                     std::span<Vec3> forces_n);

}  // namespace taut::sim
