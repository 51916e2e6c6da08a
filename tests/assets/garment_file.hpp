#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Reads an OBJ file that holds only positions and triangles. It shares no code with the program, so that it
/// is an independent check. Throws std::runtime_error for any other line.
sim::Mesh read_obj(const std::filesystem::path& file);

/// Reads the landmarks of a garment. Throws std::runtime_error for anything else in the file.
std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file);

}  // namespace taut::test
