#pragma once

#include "app/models/rig.hpp"

namespace taut::app {

/// Returns for each joint of one skeleton the part of the body it moves, such as "hips", "spine1", "left
/// upleg" or "right forearm"; for others the name in lower case, without prefixes and separators. Names are
/// compared without case; prefixes such as "mixamorig:" and "Bip01", the sides as "Left", "l" or "_L", and
/// the common names of parts are known. "LeftShoulder" is the collar bone, or the arm in a skeleton that has
/// an elbow.
std::vector<std::string> parts_of_joints(std::span<const std::string> names);

/// Returns whether the part, as parts_of_joints() names it, is one that shows when it does not move: of the
/// trunk, the arms or the legs.
bool is_main_part(const std::string& part);

/// A rig at one moment.
struct RigPose {
  std::vector<glm::dmat4> to_model;    ///< per node, from its frame into that of the model
  std::vector<double> target_weights;  ///< per target
};

/// Returns the pose in which the model was stored.
RigPose stored_pose(const Rig& rig);

/// Returns the pose at a time of the clip, in seconds from its begin: the transforms of the clip, multiplied
/// down the tree of nodes. Requires a clip of the rig.
RigPose pose_at(const Rig& rig, const RigClip& clip, double time_s);

/// Returns the pose on the way from one to another: each node turns, goes and grows evenly under the one above it.
RigPose pose_between(const Rig& rig, const RigPose& from, const RigPose& to, double share);

/// Fills `positions` with where the vertices are in the pose, in the file's unit and axes. First targets are
/// mixed in; then vertices of skinned parts go with their bones by linear blend skinning, sum of weight *
/// joint
/// * binding * vertex (Magnenat-Thalmann, Laperriere and Thalmann 1988), and others with their node. Requires
/// a span with an entry for each vertex of the rig.
void pose_vertices(const Rig& rig, const RigPose& pose, std::span<sim::Vec3> positions);
std::vector<sim::Vec3> posed_vertices(const Rig& rig, const RigPose& pose);

/// Requires that the weights of each skinned vertex sum to 1 within `weight_tolerance`; makes the sum exact.
/// Throws std::invalid_argument that names the vertex.
void require_weights(Rig& rig);

/// How far a sum of weights may be from 1. Files with weights of 8 bits are up to 0.008 away.
inline constexpr double weight_tolerance = 0.01;

/// Returns the rotation between two, both of length 1, along the shorter arc: `share` 0 is the first, 1 the
/// second. It is found by halving arcs, with quotients and roots alone.
glm::dvec4 rotation_between(const glm::dvec4& from, glm::dvec4 to, double share);

}  // namespace taut::app
