#include "sim/surroundings.hpp"

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

void require_vertex(const char* acts_on, Index vertex, std::size_t vertex_count) {
  if (vertex >= vertex_count) {
    throw std::invalid_argument(std::string(acts_on) + " vertex " + std::to_string(vertex) + ", but there are only " +
                                std::to_string(vertex_count));
  }
}

/// Returns the offset of a swinging pin from its first position, in m; 0 before 0 s.
Vec3 pin_offset(const PinMotion& motion, double time_s) {
  return motion.amplitude_m * sine_of_turns(motion.frequency_hz * std::max(time_s, 0.0));
}

/// Returns a bound in m on the distance of swinging pins from their chord. A sine's slope is at most 1, so within the
/// span the sine is at most the mean of its end values plus half of the angle.
double swing_off_chord_m(const PinMotion& motion, const TimeSpan& time) {
  const double radians_per_s = 2.0 * std::numbers::pi * std::abs(motion.frequency_hz);
  const auto size = [&](double time_s) { return std::abs(sine_of_turns(motion.frequency_hz * time_s)); };
  const double largest_sine =
      std::min(1.0, 0.5 * (size(time.from_s) + size(time.to_s) + radians_per_s * (time.to_s - time.from_s)));
  return radians_per_s * glm::length(motion.amplitude_m) *
         (radians_per_s * largest_sine * off_chord_per_acceleration(time) + off_chord_per_jump(0.0, time));
}

/// Returns the fraction of their path that led pins cover within the time.
double path_fraction(const PrescribedPins& prescribed, const TimeSpan& time) {
  const auto share_at = [&](double time_s) {
    return std::clamp((time_s - prescribed.from_s) / (prescribed.until_s - prescribed.from_s), 0.0, 1.0);
  };
  return share_at(time.to_s) - share_at(time.from_s);
}

void require_ascending(const char* what, const std::vector<Index>& vertices, std::size_t vertex_count) {
  if (!std::is_sorted(vertices.begin(), vertices.end())) {
    throw std::invalid_argument(std::string("the vertices of ") + what + " must be in ascending order");
  }
  if (!vertices.empty()) require_vertex("a motion leads", vertices.back(), vertex_count);
}

}  // namespace

Vec3 pin_displacement(const PinMotion& motion, const TimeSpan& time) {
  return pin_offset(motion, time.to_s) - pin_offset(motion, time.from_s);
}

std::vector<Vec3> pin_displacements(const Surroundings& surroundings, std::span<const Index> pins,
                                    std::span<const Vec3> from_m, const TimeSpan& time) {
  assert(time.from_s <= time.to_s);
  assert(from_m.size() == pins.size());
  std::vector<Vec3> moved_m(pins.size(), pin_displacement(surroundings.pin_motion, time));
  for (const MovingPins& group : surroundings.moving_pins) {
    const RigidMove move(group.motion, time);
    for (std::size_t k = 0; k < pins.size(); ++k) {
      if (std::binary_search(group.vertices.begin(), group.vertices.end(), pins[k])) {
        moved_m[k] = move.displacement_m(from_m[k]);
      }
    }
  }
  const PrescribedPins& prescribed = surroundings.prescribed_pins;
  for (std::size_t k = 0; k < pins.size() && !prescribed.vertices.empty(); ++k) {
    const auto found = std::lower_bound(prescribed.vertices.begin(), prescribed.vertices.end(), pins[k]);
    if (found != prescribed.vertices.end() && *found == pins[k]) {
      moved_m[k] = prescribed.by_m[static_cast<std::size_t>(found - prescribed.vertices.begin())] *
                   path_fraction(prescribed, time);
    }
  }
  return moved_m;
}

double pins_off_chord_m(const Surroundings& surroundings, std::span<const Index> pins, std::span<const Vec3> at_m,
                        double at_s, const TimeSpan& time) {
  assert(time.from_s <= time.to_s);
  assert(at_m.size() == pins.size());
  double off_m = pins.empty() ? 0.0 : swing_off_chord_m(surroundings.pin_motion, time);
  for (const MovingPins& group : surroundings.moving_pins) {
    const Pose pose = pose_at(group.motion, at_s);
    double radius_m = 0.0;
    for (std::size_t k = 0; k < pins.size(); ++k) {
      if (std::binary_search(group.vertices.begin(), group.vertices.end(), pins[k])) {
        radius_m = std::max(radius_m, distance_from_axis_m(group.motion.spin, pose.to_modelled(at_m[k])));
      }
    }
    off_m = std::max(off_m, off_chord_m(group.motion, radius_m, 0.0, time));
  }
  const PrescribedPins& prescribed = surroundings.prescribed_pins;
  for (const Vec3& by_m : prescribed.by_m) {
    const double jump_m_per_s = glm::length(by_m) / (prescribed.until_s - prescribed.from_s);
    off_m = std::max(off_m, jump_m_per_s * (off_chord_per_jump(prescribed.from_s, time) +
                                            off_chord_per_jump(prescribed.until_s, time)));
  }
  return off_m;
}

bool has_pins_of_their_own(const Surroundings& surroundings) {
  return !surroundings.moving_pins.empty() || !surroundings.prescribed_pins.vertices.empty();
}

void require_possible(const Surroundings& surroundings, std::size_t vertex_count) {
  if (!(surroundings.forces.air_drag_per_s >= 0.0)) {
    throw std::invalid_argument("the air drag must be at least 0 per second");
  }
  for (const PointForce& force : surroundings.forces.artificial_forces) {
    require_vertex("a force acts on", force.vertex, vertex_count);
  }
  for (const GrabbedVertex& held : surroundings.forces.grabbed_vertices) {
    require_vertex("a hand holds", held.vertex, vertex_count);
  }
  for (const Body& body : surroundings.bodies) {
    const auto* mesh = std::get_if<BodyMesh>(&body.shape);
    if (mesh != nullptr && !mesh->data) {
      throw std::invalid_argument("the body '" + body.name + "' is a mesh without positions and triangles");
    }
  }
  for (const MovingPins& group : surroundings.moving_pins) {
    require_ascending("moving pins", group.vertices, vertex_count);
  }
  const PrescribedPins& prescribed = surroundings.prescribed_pins;
  require_ascending("led pins", prescribed.vertices, vertex_count);
  if (prescribed.by_m.size() != prescribed.vertices.size() ||
      (!prescribed.vertices.empty() && !(prescribed.until_s > prescribed.from_s))) {
    throw std::invalid_argument("led pins need a way for each vertex and a time to go it");
  }
}

bool is_steady(const Surroundings& s, double time_s) {
  const Wind& wind = s.forces.wind;
  const bool gusts = wind.speed_m_per_s != 0.0 && (wind.gust_amplitude != 0.0 || wind.gust_turn != 0.0);
  const auto moves = [&](const Body& body) { return is_moving_after(body, time_s); };
  const auto move = [&](const MovingPins& group) { return is_moving_after(group.motion, time_s); };
  const bool leads = !s.prescribed_pins.vertices.empty() && s.prescribed_pins.until_s > time_s;
  return !gusts && !leads && !changes_after(s.forces.gravity_path, time_s) && s.pin_motion.amplitude_m == Vec3(0.0) &&
         std::none_of(s.bodies.begin(), s.bodies.end(), moves) &&
         std::none_of(s.moving_pins.begin(), s.moving_pins.end(), move);
}

}  // namespace taut::sim
