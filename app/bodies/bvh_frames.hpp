#pragma once

#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// The meaning of a number of a BVH frame.
enum class BvhChannel { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation };

/// A joint of a BVH file, or the end of a limb.
struct BvhJoint {
  std::string name;                   ///< empty: the end of a limb
  std::size_t parent = 0;             ///< the index of a joint before this one; of the root its own
  sim::Vec3 offset = sim::Vec3(0.0);  ///< from the joint above, in the file's unit
  std::vector<BvhChannel> channels;   ///< in the order in which they are applied, the last one first
  std::size_t first_number = 0;       ///< of a frame
};

/// A motion of joints (Biovision hierarchy). In its zero pose nothing is rotated, so that the frames of all
/// joints have the axes of the file.
struct BvhMotion {
  std::vector<BvhJoint> joints;  ///< the root first
  std::size_t frames = 0;
  double frame_time_s = 0.0;
  std::size_t numbers = 0;     ///< of a frame
  std::vector<double> values;  ///< lengths in the file's unit and degrees, by frame, then as the joints have them
};

/// Reads a BVH file. Throws InputError that names the file, the line, what was found and what was expected.
BvhMotion read_bvh(const std::filesystem::path& file);

/// The joints at one moment.
struct BvhPose {
  std::vector<glm::dmat3> rotations;  ///< per joint, from the zero pose, in the axes of the file
  std::vector<sim::Vec3> positions;   ///< per joint, in the file's unit
};

/// Returns the joints in a frame. Requires one that there is.
BvhPose pose_in(const BvhMotion& motion, std::size_t frame);

/// Returns the joints with nothing rotated and the root at its offset.
BvhPose zero_pose(const BvhMotion& motion);

/// The frames of a motion of joints on a body that has joints of its own, and what did not fit, for people.
struct RetargetedMotion {
  std::unique_ptr<const FrameSource> frames;
  std::vector<std::string> remarks;
};

/// Moves a body as a BVH motion says. Joints are matched by their names (rig_pose.hpp). The stored pose of
/// the body is taken as the zero pose of the motion: a matched joint is turned from there as the motion's
/// joint is turned from its zero pose, in the axes of the scene; others keep their place under the joint
/// above. The hips go as those of the motion do, times the ratio of the heights of the hips over the lowest
/// joint that both have: sideways from where they are in frame `first`; up from where they are in the
/// zero pose, or, where that has its hips near the ground, from as high over the ground as the body's are
/// over its lowest vertex. Throws InputError if the body's vertices follow no joints, or if no joint is
/// matched, with the names of both.
RetargetedMotion retarget(std::shared_ptr<const Rig> rig, ModelAxis up, BvhMotion motion, std::size_t first);

}  // namespace taut::app
