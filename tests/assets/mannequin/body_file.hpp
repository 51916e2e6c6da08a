#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// A skinned body in the pose of its file, in metres.
struct BodyFile {
  sim::Mesh mesh;
  std::vector<std::array<std::size_t, 4>> joints;  ///< joints that each vertex follows
  std::vector<std::array<float, 4>> weights;
  std::vector<std::string> names;  ///< joint names
  std::vector<int> parents;        ///< parent of each joint, -1 for the root
  std::vector<sim::Vec3> places;   ///< position of each joint in the stored pose

  std::size_t joint(const std::string& name) const;
};

/// Reads a glTF binary with one mesh, one skin and no rotated nodes, as the mannequins are. Throws std::runtime_error
/// for anything else.
BodyFile read_body(const std::filesystem::path& file);

}  // namespace taut::test
