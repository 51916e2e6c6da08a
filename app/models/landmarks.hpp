#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/models/file_vertices.hpp"
#include "app/models/placement.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Named parts of a garment, such as seams, in the order of their file.
using Landmarks = std::vector<std::pair<std::string, std::vector<sim::Index>>>;

/// The file next to a garment that names its landmarks: tshirt.obj, tshirt.landmarks.toml.
std::filesystem::path landmarks_path(const std::filesystem::path& garment);

/// Finds the landmarks in the mesh that was made of the garment and placed. The file holds lists of
/// points [x, y, z] in the garment's unit or of numbers of its vertices. Without the file there are none.
/// Throws InputError naming the file, the line, the landmark and the point or the vertex that is not there.
Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement,
                         const sim::Mesh& mesh, const FileVertices& file_vertices);

}  // namespace taut::app
