#include "sim/forces.hpp"

#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Adds to `forces_n`, in newtons, one entry per vertex of the garment, like the two functions below.
void add_gravity(const Garment& garment, const Vec3& gravity_m_per_s2, std::span<Vec3> forces_n) {
  assert(is_finite(gravity_m_per_s2));
  assert(forces_n.size() == garment.masses_kg.size());
  for (std::size_t v = 0; v < forces_n.size(); ++v) forces_n[v] += garment.masses_kg[v] * gravity_m_per_s2;
}

/// Adds -mass * air_drag_per_s * velocity to every vertex.
void add_air_drag(const Garment& garment, const State& state, double air_drag_per_s, std::span<Vec3> forces_n) {
  assert(air_drag_per_s >= 0.0);
  assert(forces_n.size() == garment.masses_kg.size() && state.current.size() == forces_n.size());
  if (air_drag_per_s == 0.0) return;
  for (std::size_t v = 0; v < forces_n.size(); ++v) {
    forces_n[v] -= (garment.masses_kg[v] * air_drag_per_s) * velocity(state, static_cast<Index>(v));
  }
}

/// k |u| of add_wind_forces, and the derivative of k |u| |u_n| by |u_n|; both in m/s.
struct NormalDrag {
  double drag = 0.0;
  double slope = 0.0;
};

/// `sine`, from 0 to 1, is that of the angle of incidence.
NormalDrag find_normal_drag(double speed_m_per_s, double sine) {
  constexpr double pi = std::numbers::pi;
  const double divisor = 4.0 + pi * sine;
  const double drag = speed_m_per_s * (4.0 + pi) / divisor;
  return {drag, drag * (4.0 + sine * sine * (4.0 + 2.0 * pi * sine)) / divisor};
}

/// Requires that every vertex exists (require_possible checks it).
void add_artificial_forces(std::span<const PointForce> artificial, std::span<Vec3> forces_n) {
  for (const PointForce& f : artificial) {
    assert(f.vertex < forces_n.size());
    forces_n[f.vertex] += f.force_n;
  }
}

}  // namespace

Vec3 hand_force(const GrabbedVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double time_step_s) {
  assert(time_step_s > 0.0);
  const double k = held.stiffness_n_per_m;
  const double c = 2.0 * std::sqrt(k * mass_kg);
  const Vec3 pull = k * (held.point_m - position_m - time_step_s * velocity_m_per_s) - c * velocity_m_per_s;
  const Vec3 force = pull / (1.0 + time_step_s * (c + time_step_s * k) / mass_kg);
  const double size = glm::length(force);
  return size > held.max_force_n ? force * (held.max_force_n / size) : force;
}

void add_hand_forces(const Garment& garment, const State& state, std::span<const GrabbedVertex> held,
                     double time_step_s, std::span<Vec3> forces_n) {
  assert(time_step_s > 0.0);
  assert(forces_n.size() == state.current.size());
  for (const GrabbedVertex& h : held) {
    assert(h.vertex < forces_n.size());
    const double mass_kg = garment.masses_kg[h.vertex];
    if (mass_kg > 0.0) {
      forces_n[h.vertex] += hand_force(h, mass_kg, state.current[h.vertex], velocity(state, h.vertex), time_step_s);
    }
  }
}

void add_wind_forces(const Garment& garment, const State& state, const Wind& wind, std::span<const float> fractions,
                     double time_step_s, std::span<Vec3> forces_n) {
  assert(time_step_s > 0.0);
  assert(fractions.empty() || fractions.size() == garment.mesh.triangles.size());
  assert(state.current.size() == garment.mesh.positions.size());
  assert(forces_n.size() == state.current.size());
  const Vec3 air_velocity =
      fractions.empty() ? wind_velocity(wind, state.time_s) : turned_wind_velocity(wind, state.time_s);
  const double half_rho = 0.5 * air_density_kg_per_m3;
  const double half_rho_c_n = half_rho * wind.pressure_coefficient;
  for (std::size_t k = 0; k < garment.mesh.triangles.size(); ++k) {
    const Triangle& t = garment.mesh.triangles[k];
    const Vec3 doubled_area = doubled_area_vector(state.current, t);
    const double doubled_size = glm::length(doubled_area);
    if (!(doubled_size > 0.0)) continue;
    const Vec3 normal = doubled_area / doubled_size;
    const Vec3 cloth_velocity = (velocity(state, t[0]) + velocity(state, t[1]) + velocity(state, t[2])) / 3.0;
    const Vec3 u = (fractions.empty() ? 1.0 : static_cast<double>(fractions[k])) * air_velocity - cloth_velocity;
    const double speed = glm::length(u);
    if (!(speed > 0.0)) continue;
    const Vec3 u_n = normal * glm::dot(u, normal);
    const NormalDrag normal_drag = find_normal_drag(speed, glm::length(u_n) / speed);
    const double tangential_drag = half_rho * wind.friction_coefficient * speed;
    // F' / m of the linearised drag, per area so that it holds for every triangle.
    const double per_density = time_step_s / garment.material.areal_density_kg_per_m2;
    const Vec3 pressure =
        u_n * (half_rho_c_n * normal_drag.drag / (1.0 + per_density * half_rho_c_n * normal_drag.slope)) +
        (u - u_n) * (tangential_drag / (1.0 + 2.0 * per_density * tangential_drag));
    const Vec3 share = pressure * (doubled_size / 6.0);
    for (const Index v : t) forces_n[v] += share;
  }
}

Vec3 gravity_at(const ExternalForces& external, double time_s) {
  return external.gravity_m_per_s2 + offset_at(external.gravity_path, time_s);
}

double max_gravity_m_per_s2(const ExternalForces& external) {
  double max_m_per_s2 = external.gravity_path.empty() ? glm::length(external.gravity_m_per_s2) : 0.0;
  for (const PathPoint& point : external.gravity_path) {
    max_m_per_s2 = std::max(max_m_per_s2, glm::length(external.gravity_m_per_s2 + point.offset));
  }
  return max_m_per_s2;
}

void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external,
                         std::span<const float> wind_fractions, double time_step_s, std::span<Vec3> forces_n) {
  assert(time_step_s > 0.0);
  assert(state.current.size() == garment.mesh.positions.size());
  add_gravity(garment, gravity_at(external, state.time_s), forces_n);
  add_wind_forces(garment, state, external.wind, wind_fractions, time_step_s, forces_n);
  add_air_drag(garment, state, external.air_drag_per_s, forces_n);
  add_artificial_forces(external.artificial_forces, forces_n);
  add_hand_forces(garment, state, external.grabbed_vertices, time_step_s, forces_n);
}

}  // namespace taut::sim
