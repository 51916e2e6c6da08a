#pragma once

#include <span>
#include <string>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// The mesh as a Wavefront OBJ file, with its vertices at `positions`: in metres, one per vertex of the mesh.
/// Every bit of the positions is kept, so that a reader measures the same lengths.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions);

}  // namespace taut::app
