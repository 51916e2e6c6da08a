#pragma once

#include <memory>
#include <optional>
#include <span>

#include "app/bodies/placed_frames.hpp"
#include "app/bodies/rig_pose.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// A body that stays thinner where it would touch itself.
struct RoomForCloth {
  Rig rig;
  std::size_t vertices = 0;  ///< that are held back
  double most_m = 0.0;       ///< the furthest, from where it would be
};

/// Leaves room for cloth where parts of a body close in on each other in one of these poses, as arms do at the
/// armpits and legs at the crotch. As the body grows from its bones, a vertex stops where another surface comes
/// near before it; it stays so much nearer to its bones in all poses. Heads, hands and feet leave none within
/// themselves. Empty if nothing comes near. The triangles are those of the mesh whose vertices `places` finds in the
/// file.
std::optional<RoomForCloth> leave_room(const Rig& rig, std::span<const RigPose> poses,
                                       const FileVertexPlaces& places,
                                       std::span<const sim::Triangle> triangles);

}  // namespace taut::app
