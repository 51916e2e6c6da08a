#pragma once

#include "prelude.hpp"

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

}  // namespace taut::app
