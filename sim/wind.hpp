#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The wind. The paper's "wind value" is the speed in m/s.
struct Wind {
  double speed_m_per_s = 0.0;
  Vec3 direction = {0.0, 0.0, -1.0};  ///< downwind direction; any length
  /// Largest relative change of the speed by gusts. At 0 the speed is steady. The turbulence intensity, which is the
  /// standard deviation of the speed over its mean, is `turbulence_per_amplitude` of it.
  double gust_amplitude = 0.0;
  double gust_period_s = 1.0;  ///< mean time from one gust to the next at a fixed point; above 0
  /// Tangent of the angle by which gusts turn the wind sideways.
  double gust_turn = 0.0;
  /// Seed of the gusts; the same seed gives the same gusts.
  std::uint64_t gust_seed = 1;
  /// Coefficient C_n of the normal force on a face at right angles to the flow; about 1.2 for a flat plate. At small
  /// angles of incidence the coefficient rises by 1.79 C_n for each radian (separated plate: 1.6; thin aerofoil: 6.3).
  double pressure_coefficient = 1.2;
  /// Coefficient C_t of the friction of air that flows along a face.
  double friction_coefficient = 0.05;

  bool operator==(const Wind&) const = default;
};

/// See Wind::gust_amplitude. It follows from the interpolation of the noise.
inline constexpr double turbulence_per_amplitude = 0.35;

/// Returns whether there is any wind.
bool blows(const Wind& wind);

/// Sets two directions at right angles to the unit vector `direction` and to each other.
void make_perpendicular(const Vec3& direction, Vec3& sideways, Vec3& upwards);

/// Returns the velocity of the air as gusts turn it but do not change its speed, in m/s. It is the same everywhere.
Vec3 turned_wind_velocity(const Wind& wind, double time_s);

/// Value noise in [-1, 1] that is twice continuously differentiable (Perlin 2002's quintic). It keeps the values at the
/// corners of the cell of the last point, as neighbours are often in the same one.
class SmoothNoise {
 public:
  explicit SmoothNoise(std::uint64_t seed) : seed_(seed) {}

  double at(const Vec3& point);

 private:
  std::uint64_t seed_;
  Vec3 cell_ = Vec3(std::numeric_limits<double>::quiet_NaN());
  std::array<double, 8> corners_ = {};
};

/// Factor of gusts on the speed of the air, at one time. Gusts travel with the mean wind (Taylor 1938); across it they
/// are half as long as along it, as in isotropic turbulence.
class GustField {
 public:
  GustField(const Wind& wind, double time_s);

  double strength(const Vec3& point_m);

 private:
  double amplitude_ = 0.0;
  double passed_ = 0.0;  ///< cells of the noise that have passed the origin
  /// Cells per m, along the wind and in two directions across it.
  Vec3 along_per_m_ = Vec3(0.0), sideways_per_m_ = Vec3(0.0), upwards_per_m_ = Vec3(0.0);
  SmoothNoise gusts_, small_gusts_;
};

/// Returns the air velocity with gusts at a point, in m/s.
Vec3 wind_velocity(const Wind& wind, double time_s, const Vec3& point_m = Vec3(0.0));

}  // namespace taut::sim
