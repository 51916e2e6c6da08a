#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// The mesh as a Wavefront OBJ file, with its vertices at `positions`: in metres, one per vertex of the mesh.
/// The file begins with the comment. `number` is a format of fmt; the default keeps every bit of the
/// positions, so that a reader measures the same lengths. `corner_uv`: texture coordinates, three per
/// triangle, or none; equal ones are written once. Requires none of a grid.
std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::span<const glm::vec2> corner_uv = {},
                     std::string comment = "# Taut; metres, y up\n", const std::string& number = "{}");

}  // namespace taut::app
