#pragma once

#include <string>
#include <vector>

#include "sim/mesh.hpp"

namespace taut::app {

/// The mesh with its vertices at the positions, as a Wavefront OBJ file that keeps every bit of their floats.
std::string obj_text(const sim::Mesh& mesh, const std::vector<sim::Vec3>& positions);

}  // namespace taut::app
