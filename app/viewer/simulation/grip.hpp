#pragma once

#include <span>
#include <vector>

#include "sim/hand.hpp"

namespace taut::app {

struct GripVertex {
  sim::Index vertex = 0;
  double share = 0.0;                    ///< of the pull; all shares together are 1
  sim::Vec3 offset_m = {0.0, 0.0, 0.0};  ///< from the vertex that was taken hold of
};

/// A hand: a few square centimetres of cloth between fingers. A single vertex would be drawn out to a needle.
struct Grip {
  std::vector<GripVertex> vertices;
  sim::Vec3 target_m = {0.0, 0.0, 0.0};  ///< where the vertex that was taken hold of shall go
};

/// A grip on the cloth around a vertex. Vertices count less the further they are along the mesh's edges.
Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex);

/// The hand at a point, as springs to vertices. They hold the whole garment's weight with a stretch of
/// millimetres and give up at some times that weight.
std::vector<sim::HeldVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m,
                                           const sim::Garment& garment);

/// The hand's next place on its way to the target: no faster than an arm.
sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s);

}  // namespace taut::app
