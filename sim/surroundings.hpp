#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/forces.hpp"

namespace taut::sim {

/// Swing of all pins about their first positions: offset = amplitude * sin(2 pi frequency t).
struct PinMotion {
  Vec3 amplitude_m = {0.0, 0.0, 0.0};
  double frequency_hz = 1.0;

  bool operator==(const PinMotion&) const = default;
};

/// Returns the displacement of swinging pins within the time, in metres.
Vec3 pin_displacement(const PinMotion& motion, const TimeSpan& time);

/// Pins that move together rigidly instead of swinging with the others.
struct MovingPins {
  std::vector<Index> vertices;  ///< ascending; vertices that are not pinned are ignored
  RigidMotion motion = {};

  bool operator==(const MovingPins&) const = default;
};

/// Pins with prescribed straight paths, one for each.
struct PrescribedPins {
  std::vector<Index> vertices;  ///< ascending; vertices that are not pinned are ignored
  std::vector<Vec3> by_m;       ///< displacement over the whole time; one entry per vertex
  double from_s = 0.0;
  double until_s = 0.0;  ///< above from_s, unless there are no vertices

  bool operator==(const PrescribedPins&) const = default;
};

/// Everything that acts on the cloth from outside.
struct Surroundings {
  ExternalForces forces;
  std::vector<Body> bodies;
  PinMotion pin_motion;
  std::vector<MovingPins> moving_pins;
  PrescribedPins prescribed_pins = {};

  bool operator==(const Surroundings&) const = default;
};

/// Checks the surroundings of a garment with `vertex_count` vertices. Throws std::invalid_argument if a force, a hand
/// or a motion refers to a vertex that does not exist, if moving or led pins are not in ascending order, if led pins
/// lack a displacement or a duration, if a body mesh has no data, or if the air drag is below 0.
void require_possible(const Surroundings& surroundings, std::size_t vertex_count);

/// Returns the displacement of each of `pins` within the time, in metres. `from_m` are their positions at its
/// beginning, one entry per pin. A pin in several groups of moving pins follows the last one. Led pins follow their own
/// path.
std::vector<Vec3> pin_displacements(const Surroundings& surroundings, std::span<const Index> pins,
                                    std::span<const Vec3> from_m, const TimeSpan& time);

/// Returns a bound in m on the distance of any of `pins` from the chord of its path, at any time of the span. `at_m`
/// are their positions at the time `at_s`, one entry per pin.
double pins_off_chord_m(const Surroundings& surroundings, std::span<const Index> pins, std::span<const Vec3> at_m,
                        double at_s, const TimeSpan& time);

/// Returns whether any pin has a motion besides the common swing.
bool has_pins_of_their_own(const Surroundings& surroundings);

/// Returns whether the surroundings are constant after this time, so that the cloth can come to rest.
bool is_steady(const Surroundings& surroundings, double time_s);

}  // namespace taut::sim
