#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/pins.hpp"

namespace taut::sim {

/// One vertex, edge or triangle of the garment, or a body.
struct ContactSide {
  std::vector<Index> vertices = {};      ///< garment vertices: one, or the corners of an edge or a triangle
  std::optional<std::size_t> body = {};  ///< index into the surroundings' bodies; `vertices` is then empty

  bool operator==(const ContactSide&) const = default;
};

/// The first two sides found that could not be kept apart.
struct BlockedContact {
  /// The second side is empty if the obstacle is unknown: contact then throws the cloth beyond the searched range.
  std::array<ContactSide, 2> sides = {};
  std::optional<ContactSide> behind = {};  ///< pins or a body that prevent them from giving way
  Vec3 place_m = {0.0, 0.0, 0.0};          ///< point between the two closest points
  double distance_m = 0.0;                 ///< distance of the closest points; 0 or less if the sides touch

  bool operator==(const BlockedContact&) const = default;
};

/// Returns a message for users: which side closes in on which, their distance and the place.
std::string describe(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies);

/// Thrown if every attempt at a frame would let something cross. The cloth stays in its state at the start of the
/// frame.
class ContactBlocked : public std::runtime_error {
 public:
  /// `time_s` is the time at which the failed frame would have ended.
  ContactBlocked(BlockedContact blocked, const Pins& pins, std::span<const Body> bodies, double time_s);

  const BlockedContact& blocked() const { return blocked_; }
  double time_s() const { return time_s_; }

 private:
  BlockedContact blocked_;
  double time_s_;
};

}  // namespace taut::sim
