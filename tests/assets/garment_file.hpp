#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Reads an OBJ file with the vertex order that the program uses. Throws std::runtime_error if a face is no triangle,
/// point or line, or if triangles do not first use the vertices in the file's order.
sim::Mesh read_obj(const std::filesystem::path& file);

/// Reads the texture coordinates of such a file: three for each triangle.
std::vector<glm::vec2> read_corner_uv(const std::filesystem::path& file);

/// Reads the landmarks of a garment. Throws std::runtime_error if the file holds anything else but metres_per_uv.
std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file);

}  // namespace taut::test
