#include "sim/forces.hpp"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

namespace taut::sim {

Vec3 gravity_at(const ExternalForces& external, double time_s) {
  return external.gravity_m_per_s2 + offset_at(external.gravity_path, time_s);
}

double largest_gravity_m_per_s2(const ExternalForces& external) {
  double largest = external.gravity_path.empty() ? glm::length(external.gravity_m_per_s2) : 0.0;
  for (const PathPoint& point : external.gravity_path) {
    largest = std::max(largest, glm::length(external.gravity_m_per_s2 + point.offset));
  }
  return largest;
}

void add_gravity(const Garment& garment, const Vec3& gravity_m_per_s2, std::span<Vec3> forces_n) {
  assert(forces_n.size() == garment.masses_kg.size());
  for (std::size_t v = 0; v < forces_n.size(); ++v) {
    forces_n[v] += garment.masses_kg[v] * gravity_m_per_s2;
  }
}

void add_air_drag(const Garment& garment, const State& state, double air_drag_per_s,
                  std::span<Vec3> forces_n) {
  assert(forces_n.size() == garment.masses_kg.size() && state.current.size() == forces_n.size());
  if (air_drag_per_s == 0.0) {
    return;
  }
  for (std::size_t v = 0; v < forces_n.size(); ++v) {
    forces_n[v] -= (garment.masses_kg[v] * air_drag_per_s) * velocity(state, static_cast<Index>(v));
  }
}

void add_artificial_forces(std::span<const PointForce> artificial, std::span<Vec3> forces_n) {
  for (const PointForce& f : artificial) {
    assert(f.vertex < forces_n.size());
    forces_n[f.vertex] += f.force_n;
  }
}

void add_external_forces(const Garment& garment, const State& state, const ExternalForces& external,
                         double time_step_s, std::span<Vec3> forces_n) {
  add_gravity(garment, gravity_at(external, state.time_s), forces_n);
  add_wind_forces(garment, state, external.wind, time_step_s, forces_n);
  add_air_drag(garment, state, external.air_drag_per_s, forces_n);
  add_artificial_forces(external.artificial_forces, forces_n);
  add_hand_forces(garment, state, external.held_vertices, time_step_s, forces_n);
}

}  // namespace taut::sim
