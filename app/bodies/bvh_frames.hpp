#pragma once

#include "app/bodies/bvh_reading.hpp"
#include "app/bodies/frame_source.hpp"
#include "app/models/rig.hpp"

namespace taut::app {

/// The frames of a motion of joints on a body that has joints of its own, and what did not fit, for people.
struct RetargetedMotion {
  std::unique_ptr<const FrameSource> frames;
  std::vector<std::string> remarks;
};

/// Moves a body as a BVH motion says. Joints are matched by their names (joint_names.hpp). The stored pose of
/// the body is taken as the zero pose of the motion: a matched joint is turned from there as the motion's
/// joint is turned from its zero pose, in the axes of the scene; others keep their place under the joint
/// above. The hips go as those of the motion do, times the ratio of the heights of the hips over the lowest
/// joint that both have: sideways from where they are in frame `first`; up from where they are in the
/// zero pose, or, where that has its hips near the ground, from as high over the ground as the body's are
/// over its lowest vertex. Throws InputError if the body's vertices follow no joints, or if no joint is
/// matched, with the names of both.
RetargetedMotion retarget(std::shared_ptr<const Rig> rig, ModelAxis up, BvhMotion motion, std::size_t first);

}  // namespace taut::app
