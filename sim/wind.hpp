#pragma once

#include <cstdint>
#include <span>

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// The paper's "wind value" is the speed in m/s.
struct Wind {
  double speed_m_per_s = 0.0;
  Vec3 direction = {0.0, 0.0, -1.0};  ///< where the air goes; need not be of length 1
  /// How much gusts raise and lower the speed, as a fraction of it: 0 is a steady wind.
  double gust_amplitude = 0.0;
  double gust_period_s = 1.0;  ///< mean time from one gust to the next
  double gust_turn = 0.0;      ///< how far gusts turn the wind sideways, as the tangent of the angle
  std::uint64_t gust_seed = 1;
  /// Force coefficient of the pressure on a face met head on: about 1.2 for a flat plate.
  double pressure_coefficient = 1.2;
  /// Force coefficient of the air that strokes along a face.
  double friction_coefficient = 0.05;

  bool operator==(const Wind&) const = default;
};

inline constexpr double air_density_kg_per_m3 = 1.2;

/// The velocity of the air at a time, gusts included, in m/s. The same seed gives the same gusts.
Vec3 wind_velocity(const Wind& wind, double time_s);

/// Adds the force of the moving or still air on every triangle, shared evenly by its corners:
/// with the air's velocity u relative to the triangle, its normal part u_n and its tangential part u_t,
///   F = 1/2 rho A (C_n |u_n| u_n + C_t |u| u_t)
/// (quadratic drag as in Keckeisen, Kimmerle, Thomaszewski and Wacker 2004). A light triangle in a strong
/// wind takes up the air's velocity within one step: the factor 1 / (1 + dt F' / m) keeps it from
/// overshooting.
void add_wind_forces(const Garment& garment, const State& state, const Wind& wind, double time_step_s,
                     std::span<Vec3> forces_n);

}  // namespace taut::sim
