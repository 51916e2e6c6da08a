#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// A skinned body as its file has it, metres.
struct BodyFile {
  sim::Mesh mesh;
  std::vector<std::array<std::size_t, 4>> joints;  ///< of every vertex
  std::vector<std::array<float, 4>> weights;
  std::vector<std::string> names;  ///< of every joint
  std::vector<int> parents;        ///< of every joint, -1 for the root
  std::vector<sim::Vec3> places;   ///< of every joint, in the pose as stored

  std::size_t joint(const std::string& name) const;
};

/// Reads a glTF binary as the mannequins are: one mesh, one skin, nothing turned. Throws std::runtime_error
/// for anything else.
BodyFile read_body(const std::filesystem::path& file);

}  // namespace taut::test
