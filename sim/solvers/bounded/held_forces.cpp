#include "sim/solvers/bounded/held_forces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/hand_force.hpp"

namespace taut::sim::bounded {
namespace {

constexpr int least_updates_per_frame = 3;
/// Wind turns with the cloth, by about as much whenever it has blown this far. More evaluations changed how a
/// shirt flies in a wind of 10 m/s by less than its own turbulence does.
constexpr double wind_update_m = 0.042;

/// Held forces are stable while rate^2 held^2 < 2 (see add_bending). At 1.3 the cloth was seen to tremble, as
/// sweeps come in between.
constexpr double largest_rate_times_held = 0.95;

/// Waves of bending faster than this, in radians per frame, are slowed down.
constexpr double fastest_bending_per_frame = 2.2;

AirFlow air_flow(const Garment& garment, const Wind& wind, double time_s, double time_step_s, double held_s) {
  const Vec3 velocity = wind_velocity(wind, time_s);
  AirFlow air;
  air.velocity_m_per_s = {static_cast<float>(velocity.x), static_cast<float>(velocity.y),
                          static_cast<float>(velocity.z)};
  const double half_density = 0.5 * air_density_kg_per_m3;
  air.half_density_pressure = static_cast<float>(half_density * wind.pressure_coefficient);
  air.half_density_friction = static_cast<float>(half_density * wind.friction_coefficient);
  air.time_per_density = static_cast<float>(held_s / garment.material.areal_density_kg_per_m2);
  air.per_time_step = static_cast<float>(1.0 / time_step_s);
  return air;
}

}  // namespace

HeldForces::HeldForces(const Garment& garment, const Pins& pins, const Layout& layout,
                       double bending_rigidity_n_m, double frame_time_s)
    : layout_(layout),
      bending_(garment, pins, layout, bending_rigidity_n_m, fastest_bending_per_frame / frame_time_s),
      accelerations_(layout.row_count()),
      corner_forces_n_(layout.triangles.lane_count()),
      positions_(layout.row_count()) {}

int HeldForces::updates_per_frame(const ExternalForces& external, double frame_time_s) const {
  const double for_wind = external.wind.speed_m_per_s * frame_time_s / wind_update_m;
  const double for_bending = bending_.largest_rate_per_s() * frame_time_s / largest_rate_times_held;
  // Vertices of next to no mass would ask for any number.
  constexpr double most = 1e6;
  const double wanted = std::ceil(std::max(for_wind, for_bending));
  return std::max(least_updates_per_frame, static_cast<int>(wanted < most ? wanted : most));
}

void HeldForces::add_gravity_and_artificial(const ExternalForces& external) {
  const Row gravity = row_of(external.gravity_m_per_s2);
  std::fill(accelerations_.begin(),
            accelerations_.begin() + static_cast<std::ptrdiff_t>(layout_.vertex_count()), gravity);
  for (const PointForce& f : external.artificial_forces) {
    if (f.vertex >= layout_.vertex_count()) {
      throw std::invalid_argument("a force acts on vertex " + std::to_string(f.vertex) +
                                  ", but there are only " + std::to_string(layout_.vertex_count()));
    }
    const Index row = layout_.row_of_vertex[f.vertex];
    add_scaled(accelerations_[row], row_of(f.force_n), layout_.inverse_masses_per_kg[row]);
  }
}

// A hand's spring is implicit over the time its force is held.
void HeldForces::add_hand(const Garment& garment, const ExternalForces& external, const Motion& motion,
                          double time_step_s, double held_s) {
  for (const HeldVertex& held : external.held_vertices) {
    if (held.vertex >= layout_.vertex_count()) {
      throw std::invalid_argument("a hand holds vertex " + std::to_string(held.vertex) +
                                  ", but there are only " + std::to_string(layout_.vertex_count()));
    }
    const Index row = layout_.row_of_vertex[held.vertex];
    const double mass_kg = garment.masses_kg[held.vertex];
    const Vec3 moved = vector_of(motion.current[row]);
    const Vec3 velocity_m_per_s = (moved - vector_of(motion.previous[row])) / time_step_s;
    if (mass_kg > 0.0) {
      add_scaled(accelerations_[row],
                 row_of(hand_force(held, mass_kg, motion.start_m[row] + moved, velocity_m_per_s, held_s)),
                 layout_.inverse_masses_per_kg[row]);
    }
  }
}

void HeldForces::add_wind(const Garment& garment, const Wind& wind, const Motion& motion, double time_s,
                          double time_step_s, double held_s, Loops& loops) {
  const TriangleLanes& triangles = layout_.triangles;
  loops.wind(triangles, air_flow(garment, wind, time_s, time_step_s, held_s), motion.start.high.data(),
             motion.current.data(), motion.previous.data(), corner_forces_n_.data());
  loops.for_rows(0, layout_.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      Row force_n;
      for (std::uint32_t k = triangles.corner_begin[row]; k < triangles.corner_begin[row + 1]; ++k) {
        add_scaled(force_n, corner_forces_n_[triangles.corner_triangles[k]], 1.0F);
      }
      add_scaled(accelerations_[row], force_n, layout_.inverse_masses_per_kg[row]);
    }
  });
}

// Bending is taken not at x but at x + v held, where the cloth will be when the interval ends. With a =
// rate^2 held^2 of a mode the step from interval to interval has the determinant 1 - a/2 and the trace 2 -
// 3a/2: stable for a < 2, and damping where bending at x itself would feed the motion.
void HeldForces::add_bending(const Motion& motion, double ahead, Loops& loops) {
  const auto factor = static_cast<float>(ahead);
  loops.for_rows(0, layout_.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Row& d = motion.current[row];
      const Row& p = motion.previous[row];
      const Row& x = motion.start.high[row];
      positions_[row] = {x.x + (d.x + (d.x - p.x) * factor), x.y + (d.y + (d.y - p.y) * factor),
                         x.z + (d.z + (d.z - p.z) * factor), 0.0F};
    }
  });
  bending_.add_accelerations(positions_, loops, accelerations_);
}

void HeldForces::update(const Garment& garment, const ExternalForces& external, const Motion& motion,
                        double time_s, double time_step_s, double held_s, Loops& loops) {
  add_gravity_and_artificial(external);
  add_hand(garment, external, motion, time_step_s, held_s);
  add_wind(garment, external.wind, motion, time_s, time_step_s, held_s, loops);
  if (!bending_.empty()) {
    add_bending(motion, held_s / time_step_s, loops);
  }
}

}  // namespace taut::sim::bounded
