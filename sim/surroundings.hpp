#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/forces.hpp"

namespace taut::sim {

/// All pins swing together about their first positions: offset = amplitude * sin(2 pi frequency t).
struct PinMotion {
  Vec3 amplitude_m = {0.0, 0.0, 0.0};
  double frequency_hz = 1.0;

  bool operator==(const PinMotion&) const = default;
};

/// Returns how far swinging pins move within the time, in metres.
Vec3 pin_displacement(const PinMotion& motion, const TimeSpan& time);

/// Pins that move together as something rigid does. They do not swing with the others.
struct MovingPins {
  std::vector<Index> vertices;  ///< ascending; those that are not pinned are left alone
  RigidMotion motion = {};

  bool operator==(const MovingPins&) const = default;
};

/// Pins that each go straight to a place of their own, whatever the others do.
struct LedPins {
  std::vector<Index> vertices;  ///< ascending; those that are not pinned are left alone
  std::vector<Vec3> by_m;       ///< how far each goes; one entry per vertex
  double from_s = 0.0;
  double until_s = 0.0;  ///< above from_s, unless there are no vertices

  bool operator==(const LedPins&) const = default;
};

/// Everything that acts on the cloth from outside.
struct Surroundings {
  ExternalForces forces;
  std::vector<Body> bodies;
  PinMotion pin_motion;
  std::vector<MovingPins> moving_pins;
  LedPins led_pins = {};

  bool operator==(const Surroundings&) const = default;
};

/// Checks the surroundings of a garment with `vertex_count` vertices. Throws std::invalid_argument if a force
/// or a hand acts on a vertex that does not exist, or if one moves. Throws it also if moving or led pins are
/// not in ascending order, if led pins lack a way or time, or if the air drag is below 0.
void require_possible(const Surroundings& surroundings, std::size_t vertex_count);

/// Returns how far each of `pins` moves within the time, in metres, from where it is at its beginning, which
/// is `from_m`, one entry per pin. A pin that is in several groups of moving pins moves with the last; one
/// that is led goes its own way.
std::vector<Vec3> pin_displacements(const Surroundings& surroundings, std::span<const Index> pins,
                                    std::span<const Vec3> from_m, const TimeSpan& time);

/// Returns a bound on how far any of `pins` is off the chord of its path at any time of the span, in m. They
/// are at `at_m` at the time `at_s`, one entry per pin.
double pins_off_chord_m(const Surroundings& surroundings, std::span<const Index> pins, std::span<const Vec3> at_m,
                        double at_s, const TimeSpan& time);

/// Returns whether any pin moves otherwise than by swinging with all others.
bool has_pins_of_their_own(const Surroundings& surroundings);

/// Returns whether nothing outside changes after this time, so that the cloth can come to rest.
bool is_steady(const Surroundings& surroundings, double time_s);

}  // namespace taut::sim
