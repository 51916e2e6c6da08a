#pragma once

#include <filesystem>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// Reads a point cache (PC2, version 1): where each vertex of a model is in each frame, by frame, then by
/// vertex, in the model's unit and axes. Its own frame rate is not looked at. Throws InputError that names
/// the file, the frame and the vertex, what was found and what was expected.
std::vector<std::vector<sim::Vec3>> read_pc2(const std::filesystem::path& file);

}  // namespace taut::app
