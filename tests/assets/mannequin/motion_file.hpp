#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <map>
#include <string>
#include <vector>

#include "mannequin/body_file.hpp"

namespace taut::test {

/// A frame of a BVH file: the root's position and the rotation of each joint.
struct MotionFrame {
  sim::Vec3 root_m = sim::Vec3(0.0);
  std::map<std::string, glm::dmat3> turns;
};

struct MotionFile {
  double frame_time_s = 0.0;
  std::map<std::string, sim::Vec3> offsets_m;  ///< offset of each joint from its parent
  std::vector<MotionFrame> frames;
};

/// Reads a BVH file in which each joint has rotations about z, x and y, and the root has a position as well. Throws
/// std::runtime_error for anything else.
MotionFile read_motion(const std::filesystem::path& file);

/// Returns the positions of the body's vertices in that frame, by linear blend skinning. The root's displacement
/// since the first frame is scaled by the height of the hips.
std::vector<sim::Vec3> pose_body(const BodyFile& body, const MotionFile& motion, std::size_t frame);

}  // namespace taut::test
