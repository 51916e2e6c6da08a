#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Reads the positions and triangles of an OBJ file that holds nothing else, with an eye of its own: not
/// through the code that wrote it. Throws std::runtime_error on any other line.
sim::Mesh read_obj(const std::filesystem::path& file);

/// Named lists of vertices. Throws on anything else.
std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file);

}  // namespace taut::test
