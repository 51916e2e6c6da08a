#pragma once

#include <span>
#include <string>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// The mesh with its vertices at the positions, as a Wavefront OBJ file that keeps every bit of them: who
/// reads it finds the lengths that were simulated.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions);

}  // namespace taut::app
