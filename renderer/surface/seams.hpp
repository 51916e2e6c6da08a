#pragma once

#include <glm/vec2.hpp>

#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {

/// Returns the edges along which a mesh is sewn. With texture coordinates, three for each triangle: those at
/// which they differ between two triangles. Without: those at which two triangles meet at more than 50
/// degrees at rest.
std::vector<VertexPair> seam_edges(std::span<const glm::vec3> rest_positions,
                                   std::span<const std::uint32_t> triangles,
                                   std::span<const glm::vec2> corner_coordinates = {});

}  // namespace taut::renderer
