#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/pins.hpp"

namespace taut::sim {

/// A part of the garment, or of a body.
struct ContactSide {
  std::vector<Index> vertices = {};      ///< of the garment: one, those of an edge or of a triangle
  std::optional<std::size_t> body = {};  ///< its place among the surroundings' bodies; then no vertices

  bool operator==(const ContactSide&) const = default;
};

/// Two things that could not be kept apart, the first ones that were found.
struct BlockedContact {
  /// The second has neither vertices nor a body where it is not known what the first would meet: where
  /// contact throws cloth further than anything was looked for.
  std::array<ContactSide, 2> sides = {};
  std::optional<ContactSide> behind = {};  ///< pins or a body that keep them from giving way
  Vec3 place_m = {0.0, 0.0, 0.0};          ///< between the two, where they are nearest
  double distance_m = 0.0;                 ///< of the two there; not above 0 where they touch

  bool operator==(const BlockedContact&) const = default;
};

/// Returns what closes in on what, how far apart they were and where, for people.
std::string describe(const BlockedContact& blocked, const Pins& pins, std::span<const Body> bodies);

/// A frame could not be made without something crossing. The cloth is as it was when the frame began.
class ContactBlocked : public std::runtime_error {
 public:
  /// In the frame that would have ended at `time_s`.
  ContactBlocked(BlockedContact blocked, const Pins& pins, std::span<const Body> bodies, double time_s);

  const BlockedContact& blocked() const { return blocked_; }
  double time_s() const { return time_s_; }

 private:
  BlockedContact blocked_;
  double time_s_;
};

}  // namespace taut::sim
