#include "sim/surroundings.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

void require_vertex(const char* acts_on, Index vertex, std::size_t vertex_count) {
  if (vertex >= vertex_count) {
    throw std::invalid_argument(std::string(acts_on) + " vertex " + std::to_string(vertex) +
                                ", but there are only " + std::to_string(vertex_count));
  }
}

}  // namespace

Vec3 pin_offset(const PinMotion& motion, double time_s) {
  return motion.amplitude_m * sine_of_turns(motion.frequency_hz * time_s);
}

Vec3 pin_displacement(const PinMotion& motion, double from_s, double to_s) {
  return pin_offset(motion, to_s) - pin_offset(motion, from_s);
}

void require_possible(const Surroundings& surroundings, std::size_t vertex_count) {
  if (!(surroundings.layer_distance_m >= 0.0)) {
    throw std::invalid_argument("the distance of layers must be at least 0 m");
  }
  if (!(surroundings.forces.air_drag_per_s >= 0.0)) {
    throw std::invalid_argument("the air drag must be at least 0 per second");
  }
  for (const PointForce& force : surroundings.forces.artificial_forces) {
    require_vertex("a force acts on", force.vertex, vertex_count);
  }
  for (const HeldVertex& held : surroundings.forces.held_vertices) {
    require_vertex("a hand holds", held.vertex, vertex_count);
  }
}

bool is_steady(const Surroundings& s, double time_s) {
  const Wind& wind = s.forces.wind;
  const bool gusts = wind.speed_m_per_s != 0.0 && (wind.gust_amplitude != 0.0 || wind.gust_turn != 0.0);
  const auto moves = [&](const auto& what) { return is_moving_after(what, time_s); };
  return !gusts && s.pin_motion.amplitude_m == Vec3(0.0) &&
         std::none_of(s.bodies.begin(), s.bodies.end(), moves);
}

}  // namespace taut::sim
