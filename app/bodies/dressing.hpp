#pragma once

#include <memory>
#include <vector>

#include "app/bodies/placed_frames.hpp"
#include "app/bodies/rig_pose.hpp"
#include "sim/contact/bodies.hpp"

namespace taut::app {

/// Returns a body that is thin: each vertex of the pose is moved most of the way to the nearest points of the
/// bones it follows, weighted as it follows them. A bone goes from a joint to each joint below it that
/// vertices follow; without one it is the joint itself. In the file's unit and axes, per vertex of the rig.
/// Throws InputError if vertices follow no joint.
std::vector<sim::Vec3> thin_shape(const Rig& rig, const RigPose& pose);

/// How a body grows into what it wears.
struct Growth {
  std::vector<sim::Vec3> thin_m;  ///< per vertex of the body, where it begins
  std::vector<sim::Vec3> full_m;  ///< where it is at 0 s
  double duration_s = 0.0;        ///< before 0 s
};

/// A motion with a growth before it: vertices go straight, slowly at both ends. `rate_hz` is that of the
/// motion, and of the growth if there is none, which is null.
std::shared_ptr<const sim::BodyFrames> with_growth(Growth growth,
                                                   std::shared_ptr<const sim::BodyFrames> motion,
                                                   double rate_hz);

}  // namespace taut::app
