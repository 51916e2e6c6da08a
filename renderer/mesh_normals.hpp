#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace taut::renderer {

/// How much each triangle counts in the normal of a vertex.
enum class NormalWeight {
  area,   ///< cheapest; good where triangles are of like size
  angle,  ///< by the triangle's angle at the vertex (Thuermer and Wuethrich 1998): independent of how a face
          ///< is cut
};

/// Smooth unit normals, one for each position. `triangles` holds three indices a triangle, counter-clockwise
/// seen from outside. Degenerate triangles count nothing; a vertex without any gets +y. Needs
/// normals.size() == positions.size() and indices within range (asserted).
void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals, NormalWeight weight = NormalWeight::angle);

}  // namespace taut::renderer
