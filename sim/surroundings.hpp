#pragma once

#include <vector>

#include "sim/contact/colliders.hpp"
#include "sim/forces.hpp"

namespace taut::sim {

/// A harmonic motion of all pins about where they began, as of a shaken hanger.
struct PinMotion {
  Vec3 amplitude_m = {0.0, 0.0, 0.0};
  double frequency_hz = 1.0;

  bool operator==(const PinMotion&) const = default;
};

/// Of every pin from where it began, in metres.
Vec3 pin_offset(const PinMotion& motion, double time_s);

/// How far all pins move from one time to another, in m.
Vec3 pin_displacement(const PinMotion& motion, double from_s, double to_s);

/// Everything that acts on the cloth from outside.
struct Surroundings {
  ExternalForces forces;
  std::vector<Collider> colliders;
  /// Kept between vertices of different layers of the cloth; 0 lets layers pass through each other. About
  /// the mesh's mean edge length holds layers apart; less leaks, more stiffens folds.
  double layer_distance_m = 0.0;
  PinMotion pin_motion;

  bool operator==(const Surroundings&) const = default;
};

/// Throws std::invalid_argument on what cannot be around a garment of that many vertices: a force on a vertex
/// or a hand at a vertex that is not there, a distance or an air drag below 0.
void require_possible(const Surroundings& surroundings, std::size_t vertex_count);

/// Whether nothing outside changes with time, so that cloth can come to rest for good.
bool is_steady(const Surroundings& surroundings);

}  // namespace taut::sim
