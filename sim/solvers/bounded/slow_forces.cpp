#include "sim/solvers/bounded/slow_forces.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// Largest number of updates per frame. Vertices of almost no mass would need any number.
constexpr double max_updates_per_frame = 1e6;

/// Returns the cube of the bending length (Peirce 1930): rigidity over weight.
double cubed_bending_length_m3(double rigidity_n_m, double areal_density_kg_per_m2) {
  assert(rigidity_n_m >= 0.0);
  assert(areal_density_kg_per_m2 > 0.0);
  constexpr double gravity_m_per_s2 = 9.81;
  return rigidity_n_m / (areal_density_kg_per_m2 * gravity_m_per_s2);
}

double max_element_rate_per_s(const Garment& garment, double rigidity_n_m) {
  const double edge_m = mean_edge_m(garment.springs);
  double cubed_m3 = cubed_bending_length_m3(rigidity_n_m, garment.material.areal_density_kg_per_m2);
  for (const Material& other : garment.other_materials) {
    cubed_m3 = std::max(cubed_m3, cubed_bending_length_m3(other.bending_rigidity_n_m, other.areal_density_kg_per_m2));
  }
  const double cubed_edges = cubed_m3 / (edge_m * edge_m * edge_m);
  const double edges = std::cbrt(cubed_edges);
  const double ratio = cubed_edges / std::pow(tuning::edges_in_bending_length, 3);
  const double rise = std::clamp(ratio * ratio, 1.0, std::max(tuning::max_rise_per_edge * edges, 1.0));
  return rise * tuning::max_element_rate_per_s;
}

int whole_updates(double wanted) {
  return std::max(1, static_cast<int>(std::min(max_updates_per_frame, std::ceil(wanted))));
}

Float4 velocity_m_per_s(const Motion& motion, std::size_t row, float per_step) {
  return multiply(scaled_sum(motion.current[row], motion.previous[row], -1.0F), per_step);
}

AirFlow air_flow(const Garment& garment, const Wind& wind, const Lanes<float>& fractions, double time_s,
                 double time_step_s, double interval_s) {
  assert(time_step_s > 0.0);
  assert(interval_s > 0.0);
  const Vec3 velocity = turned_wind_velocity(wind, time_s);
  AirFlow air;
  air.fractions = fractions.data();
  air.velocity_m_per_s = {static_cast<float>(velocity.x), static_cast<float>(velocity.y),
                          static_cast<float>(velocity.z)};
  const double half_density = 0.5 * air_density_kg_per_m3;
  air.half_density_pressure = static_cast<float>(half_density * wind.pressure_coefficient);
  air.half_density_friction = static_cast<float>(half_density * wind.friction_coefficient);
  air.time_per_density = static_cast<float>(interval_s / min_density_kg_per_m2(garment));
  air.per_time_step = static_cast<float>(1.0 / time_step_s);
  return air;
}

}  // namespace

SlowForces::SlowForces(const Garment& garment, const Pins& pins, const Layout& layout, double bending_rigidity_n_m)
    : layout_(layout),
      bending_(garment, pins, layout, bending_rigidity_n_m, max_element_rate_per_s(garment, bending_rigidity_n_m)),
      accelerations_(layout.row_count()),
      corner_forces_n_(layout.triangles.lane_count()),
      wind_accelerations_(layout.row_count()),
      wind_fractions_(layout.triangles.lane_count(), 1.0F),
      constraint_velocity_m_per_s_(layout.row_count()),
      positions_(layout.row_count()) {}

int SlowForces::wind_updates_per_frame(double frame_time_s) {
  assert(frame_time_s > 0.0);
  return std::max(1, static_cast<int>(std::lround(tuning::min_updates_per_s * frame_time_s)));
}

int SlowForces::updates_per_frame(double frame_time_s) const {
  assert(frame_time_s > 0.0);
  const double for_bending = bending_.max_rate_per_s() * frame_time_s / tuning::max_rate_times_interval;
  return std::max(wind_updates_per_frame(frame_time_s), whole_updates(for_bending));
}

void SlowForces::begin_attempt(const Float4Array& wind_velocity_m_per_s, std::span<const float> wind_fractions) {
  assert(wind_fractions.size() <= wind_fractions_.size());
  wind_velocity_m_per_s_ = wind_velocity_m_per_s;
  std::fill(wind_fractions_.begin(), wind_fractions_.end(), 1.0F);
  std::copy(wind_fractions.begin(), wind_fractions.end(), wind_fractions_.begin());
}

void SlowForces::add_gravity_and_artificial(const ExternalForces& external, double time_s) {
  const Float4 gravity = to_float4(gravity_at(external, time_s));
  std::fill(accelerations_.begin(), accelerations_.begin() + static_cast<std::ptrdiff_t>(layout_.vertex_count()),
            gravity);
  for (const PointForce& f : external.artificial_forces) {
    assert(f.vertex < layout_.vertex_count());
    const Index row = layout_.solver_indices[f.vertex];
    add_scaled(accelerations_[row], to_float4(f.force_n), layout_.inverse_masses_per_kg[row]);
  }
}

// The hand's spring takes one implicit step from update to update.
void SlowForces::add_hand(const Garment& garment, const ExternalForces& external, const Motion& motion,
                          double time_step_s, double interval_s) {
  for (const GrabbedVertex& held : external.grabbed_vertices) {
    assert(held.vertex < layout_.vertex_count());
    const Index row = layout_.solver_indices[held.vertex];
    const double mass_kg = garment.masses_kg[held.vertex];
    const Vec3 moved = to_vec3(motion.current[row]);
    const Vec3 velocity_m_per_s = (moved - to_vec3(motion.previous[row])) / time_step_s;
    if (mass_kg > 0.0) {
      add_scaled(accelerations_[row],
                 to_float4(hand_force(held, mass_kg, motion.start_m[row] + moved, velocity_m_per_s, interval_s)),
                 layout_.inverse_masses_per_kg[row]);
    }
  }
}

void SlowForces::find_constraint_velocity(const Motion& motion, double time_step_s) {
  assert(time_step_s > 0.0);
  const auto per_step = static_cast<float>(1.0 / time_step_s);
  for (std::size_t row = 0; row < layout_.vertex_count(); ++row) {
    const bool is_free = layout_.inverse_masses_per_kg[row] > 0.0F;
    if (!is_free || wind_velocity_m_per_s_.empty()) {
      constraint_velocity_m_per_s_[row] = {0.0F, 0.0F, 0.0F, is_free ? 1.0F : 0.0F};
      continue;
    }
    constraint_velocity_m_per_s_[row] =
        scaled_sum(velocity_m_per_s(motion, row, per_step), wind_velocity_m_per_s_[row], -1.0F);
    constraint_velocity_m_per_s_[row].fourth = 1.0F;
  }
}

void SlowForces::update_wind(const Garment& garment, const Wind& wind, const Motion& motion, double time_s,
                             double time_step_s, double interval_s, ParallelKernels& kernels) {
  assert(time_step_s > 0.0);
  assert(interval_s > 0.0);
  const TriangleLanes& triangles = layout_.triangles;
  find_constraint_velocity(motion, time_step_s);
  kernels.wind(triangles, air_flow(garment, wind, wind_fractions_, time_s, time_step_s, interval_s),
               motion.start.high.data(), motion.current.data(), motion.previous.data(),
               constraint_velocity_m_per_s_.data(), corner_forces_n_.data());
  wind_velocity_m_per_s_.resize(layout_.row_count());
  const auto per_step = static_cast<float>(1.0 / time_step_s);
  const auto interval = static_cast<float>(interval_s);
  kernels.for_rows(0, layout_.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      Float4 force_n;
      for (std::uint32_t k = triangles.corner_begin[row]; k < triangles.corner_begin[row + 1]; ++k) {
        add_scaled(force_n, corner_forces_n_[triangles.corner_triangles[k]], 1.0F);
      }
      wind_accelerations_[row] = multiply(force_n, layout_.inverse_masses_per_kg[row]);
      wind_velocity_m_per_s_[row] =
          scaled_sum(velocity_m_per_s(motion, row, per_step), wind_accelerations_[row], interval);
    }
  });
}

void SlowForces::add_wind(ParallelKernels& kernels) {
  kernels.for_rows(0, layout_.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      add_scaled(accelerations_[row], wind_accelerations_[row], 1.0F);
    }
  });
}

// Bending is evaluated at x + v interval, the predicted position at the end of the interval. For a mode with a = rate^2
// interval^2, the step from interval to interval has the determinant 1 - a/2 and the trace 2 - 3a/2. It is stable for a
// < 2 and damps the motion. Bending evaluated at x itself would add energy.
void SlowForces::add_bending(const Motion& motion, double ahead, ParallelKernels& kernels) {
  const auto factor = static_cast<float>(ahead);
  kernels.for_rows(0, layout_.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Float4& d = motion.current[row];
      const Float4& p = motion.previous[row];
      const Float4& x = motion.start.high[row];
      positions_[row] = {x.x + (d.x + (d.x - p.x) * factor), x.y + (d.y + (d.y - p.y) * factor),
                         x.z + (d.z + (d.z - p.z) * factor), 0.0F};
    }
  });
  bending_.add_accelerations(positions_, kernels, accelerations_);
}

void SlowForces::update(const Garment& garment, const ExternalForces& external, const Motion& motion, double time_s,
                        double time_step_s, double interval_s, ParallelKernels& kernels) {
  assert(time_step_s > 0.0);
  assert(interval_s > 0.0);
  assert(std::isfinite(time_s));
  add_gravity_and_artificial(external, time_s);
  add_hand(garment, external, motion, time_step_s, interval_s);
  add_wind(kernels);
  if (!bending_.empty()) add_bending(motion, interval_s / time_step_s, kernels);
}

}  // namespace taut::sim::bounded
