#pragma once

#include <vector>

#include "sim/contact/bodies.hpp"
#include "sim/forces.hpp"

namespace taut::sim {

/// All pins swing together about their first positions: offset = amplitude * sin(2 pi frequency t).
struct PinMotion {
  Vec3 amplitude_m = {0.0, 0.0, 0.0};
  double frequency_hz = 1.0;

  bool operator==(const PinMotion&) const = default;
};

/// Returns the offset of every pin from its first position, in metres.
Vec3 pin_offset(const PinMotion& motion, double time_s);

/// Returns how far all pins move between two times, in metres.
Vec3 pin_displacement(const PinMotion& motion, double from_s, double to_s);

/// Everything that acts on the cloth from outside.
struct Surroundings {
  ExternalForces forces;
  std::vector<Body> bodies;
  /// The distance kept between vertices of different layers of the cloth, in metres. At 0 the layers pass
  /// through each other. About the mean edge length of the mesh is a good value: at less, layers pass through
  /// each other in places; at more, folds get stiffer.
  double layer_distance_m = 0.0;
  PinMotion pin_motion;

  bool operator==(const Surroundings&) const = default;
};

/// Checks the surroundings of a garment with `vertex_count` vertices. Throws std::invalid_argument if a force
/// or a hand acts on a vertex that does not exist. Throws it also if the layer distance or the air drag is
/// below 0.
void require_possible(const Surroundings& surroundings, std::size_t vertex_count);

/// Returns whether nothing outside changes after this time, so that the cloth can come to rest.
bool is_steady(const Surroundings& surroundings, double time_s);

}  // namespace taut::sim
