#pragma once

#include "app/models/reading/rig.hpp"

namespace taut::app {

/// Returns, for each joint of one skeleton, the part of the body that it moves, such as "hips", "spine1", "left upleg"
/// or "right forearm". For other joints it is the name in lower case, without prefixes and separators. Case is ignored.
/// Prefixes such as "mixamorig:" and "Bip01", sides as "Left", "l" or "_L", and the common names of parts are known.
/// "LeftShoulder" is the collar bone, or the arm in a skeleton that has an elbow.
std::vector<std::string> parts_of_joints(std::span<const std::string> names);

/// Returns whether a part, as parts_of_joints() names it, belongs to the trunk, the arms, the legs or the head, where a
/// missing motion is visible.
bool is_main_part(const std::string& part);

/// A rig at one moment.
struct RigPose {
  std::vector<glm::dmat4> to_model;    ///< per node, from its axes to the model's
  std::vector<double> target_weights;  ///< per target
};

/// Returns the pose in which the model was stored.
RigPose stored_pose(const Rig& rig);

/// Returns the pose at a time of the clip, in seconds from its start. The transforms of the clip are multiplied down
/// the tree of nodes. Requires a clip of the rig.
RigPose pose_at(const Rig& rig, const RigClip& clip, double time_s);

/// Returns a pose between two others: each node turns, moves and grows evenly relative to the node above it.
RigPose pose_between(const Rig& rig, const RigPose& from, const RigPose& to, double share);

/// Fills `positions` with the vertices in the pose, in the file's unit and axes. Targets are mixed in first. Vertices
/// of skinned parts then follow their bones by linear blend skinning, the sum of weight * joint * binding * vertex
/// (Magnenat-Thalmann, Laperriere and Thalmann 1988). Other vertices follow their node. Requires a span with an entry
/// for each vertex of the rig.
void pose_vertices(const Rig& rig, const RigPose& pose, std::span<sim::Vec3> positions);
std::vector<sim::Vec3> posed_vertices(const Rig& rig, const RigPose& pose);

/// Requires that the weights of each skinned vertex sum to 1 within `weight_tolerance`, and makes the sum exact. Throws
/// std::invalid_argument that names the vertex.
void require_weights(Rig& rig);

/// Largest difference of a sum of weights from 1. Files with weights of 8 bits differ by up to 0.008.
inline constexpr double weight_tolerance = 0.01;

/// Returns the rotation between two, both of length 1, along the shorter arc. A `share` of 0 is the first, 1 the
/// second. Arcs are halved, so that only quotients and roots are used.
glm::dvec4 rotation_between(const glm::dvec4& from, glm::dvec4 to, double share);

}  // namespace taut::app
