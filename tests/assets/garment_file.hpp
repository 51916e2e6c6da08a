#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Reads an OBJ file as the program does. Throws std::runtime_error if there are faces that are no triangles,
/// points or lines, or vertices in another order than triangles first use them.
sim::Mesh read_obj(const std::filesystem::path& file);

/// Reads the texture coordinates of such a file: three per triangle.
std::vector<glm::vec2> read_corner_uv(const std::filesystem::path& file);

/// Reads the landmarks of a garment. Throws std::runtime_error for anything else in the file, apart from its
/// metres_per_uv.
std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file);

}  // namespace taut::test
