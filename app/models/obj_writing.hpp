#pragma once

#include <span>
#include <string>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// The mesh as a Wavefront OBJ file, with its vertices at `positions`: in metres, one per vertex of the mesh.
/// The file begins with the comment. `number` is a format of fmt; the default keeps every bit of the
/// positions, so that a reader measures the same lengths.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::string comment = "# Taut; metres, y up\n", const std::string& number = "{}");

}  // namespace taut::app
