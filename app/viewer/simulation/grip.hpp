#pragma once

#include <span>
#include <vector>

#include "sim/hand.hpp"

namespace taut::app {

/// One vertex of a grip.
struct GripVertex {
  sim::Index vertex = 0;
  double share = 0.0;                    ///< fraction of the pull; all shares add up to 1
  sim::Vec3 offset_m = {0.0, 0.0, 0.0};  ///< from the vertex that was taken hold of
};

/// A hand that holds some square centimetres of cloth. A single vertex would be pulled out to a point.
struct Grip {
  std::vector<GripVertex> vertices;
  sim::Vec3 target_m = {0.0, 0.0, 0.0};  ///< where the vertex that was taken hold of should go
};

/// A grip around a vertex. Shares shrink with the distance along edges. `positions`: metres, per vertex.
Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex);

/// The hand at a point, as springs to vertices. They hold the whole garment's weight with a stretch of
/// millimetres and give up at some times that weight.
std::vector<sim::HeldVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m,
                                           const sim::Garment& garment);

/// Position of the hand after `time_s`, on its way to the target. It is no faster than an arm.
sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s);

}  // namespace taut::app
