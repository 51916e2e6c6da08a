#include "sim/wind.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace taut::sim {
namespace {

/// Neighbouring values of the noise are independent, so one rise and fall takes about two cells.
constexpr double cells_per_period = 2.0;
/// Gusts within gusts, which the von Karman spectrum has too: their number and their size, as a fraction.
constexpr double small_gusts_per_gust = 3.0;
constexpr double small_gust_amplitude = 0.5;

/// Returns a pseudo-random value in [-1, 1] for a point of the lattice (the finaliser of MurmurHash3 by Appleby).
double lattice_value(const std::array<std::int64_t, 3>& cell, std::uint64_t seed) {
  std::uint64_t h = static_cast<std::uint64_t>(cell[0]) * 0x9E3779B97F4A7C15ULL +
                    static_cast<std::uint64_t>(cell[1]) * 0xC2B2AE3D27D4EB4FULL +
                    static_cast<std::uint64_t>(cell[2]) * 0x165667B19E3779F9ULL + seed;
  h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDULL;
  h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53ULL;
  h ^= h >> 33;
  return static_cast<double>(h >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace

double SmoothNoise::at(const Vec3& point) {
  const Vec3 cell = glm::floor(point);
  if (cell != cell_) {
    cell_ = cell;
    for (int corner = 0; corner < 8; ++corner) {
      corners_[corner] = lattice_value(
          {static_cast<std::int64_t>(cell.x) + (corner & 1), static_cast<std::int64_t>(cell.y) + (corner >> 1 & 1),
           static_cast<std::int64_t>(cell.z) + (corner >> 2)},
          seed_);
    }
  }
  const Vec3 t = point - cell;
  const Vec3 blend = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  std::array<double, 4> along_y = {};
  for (int k = 0; k < 4; ++k) along_y[k] = glm::mix(corners_[2 * k], corners_[2 * k + 1], blend.x);
  return glm::mix(glm::mix(along_y[0], along_y[1], blend.y), glm::mix(along_y[2], along_y[3], blend.y), blend.z);
}

bool blows(const Wind& wind) { return wind.speed_m_per_s != 0.0 && glm::length(wind.direction) > 0.0; }

void make_perpendicular(const Vec3& direction, Vec3& sideways, Vec3& upwards) {
  const Vec3 helper = std::abs(direction.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
  sideways = glm::normalize(glm::cross(direction, helper));
  upwards = glm::cross(sideways, direction);
}

Vec3 turned_wind_velocity(const Wind& wind, double time_s) {
  assert(std::isfinite(time_s));
  if (!blows(wind)) return Vec3(0.0);
  const Vec3 direction = glm::normalize(wind.direction);
  if (wind.gust_turn == 0.0) return wind.speed_m_per_s * direction;
  Vec3 sideways, upwards;
  make_perpendicular(direction, sideways, upwards);
  const Vec3 phase = {cells_per_period * time_s / wind.gust_period_s, 0.0, 0.0};
  const Vec3 turn =
      sideways * SmoothNoise(wind.gust_seed + 1).at(phase) + upwards * SmoothNoise(wind.gust_seed + 2).at(phase);
  return wind.speed_m_per_s * (direction + wind.gust_turn * turn);
}

GustField::GustField(const Wind& wind, double time_s) : gusts_(wind.gust_seed), small_gusts_(wind.gust_seed + 3) {
  assert(std::isfinite(time_s));
  assert(wind.gust_period_s > 0.0);
  if (wind.gust_amplitude == 0.0 || !blows(wind)) return;
  amplitude_ = wind.gust_amplitude / (1.0 + small_gust_amplitude);
  const double per_s = cells_per_period / wind.gust_period_s;
  const double per_m = per_s / wind.speed_m_per_s;
  const Vec3 direction = glm::normalize(wind.direction);
  Vec3 sideways, upwards;
  make_perpendicular(direction, sideways, upwards);
  passed_ = per_s * time_s;
  along_per_m_ = per_m * direction;
  sideways_per_m_ = 2.0 * per_m * sideways;
  upwards_per_m_ = 2.0 * per_m * upwards;
}

double GustField::strength(const Vec3& point_m) {
  if (amplitude_ == 0.0) return 1.0;
  const Vec3 phase = {passed_ - glm::dot(along_per_m_, point_m), glm::dot(sideways_per_m_, point_m),
                      glm::dot(upwards_per_m_, point_m)};
  return 1.0 + amplitude_ * (gusts_.at(phase) + small_gust_amplitude * small_gusts_.at(small_gusts_per_gust * phase));
}

Vec3 wind_velocity(const Wind& wind, double time_s, const Vec3& point_m) {
  return GustField(wind, time_s).strength(point_m) * turned_wind_velocity(wind, time_s);
}

}  // namespace taut::sim
