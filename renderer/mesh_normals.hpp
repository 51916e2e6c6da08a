#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace taut::renderer {

/// The weight of each triangle's normal in the normal of a vertex.
enum class NormalWeight {
  area,   ///< the triangle's area; cheapest, good where triangles have like sizes
  angle,  ///< the triangle's angle at the vertex (Thuermer and Wuethrich 1998), which does not depend on how
          ///< a face is triangulated
};

/// Fills `normals` with one unit normal per vertex. n = number of vertices = positions.size(). `triangles`
/// holds three vertex indices per triangle, counter-clockwise seen from outside. Triangles without area are
/// ignored. A vertex without any other triangle gets +y. Requires normals.size() == n and indices below n
/// (asserted).
void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals, NormalWeight weight = NormalWeight::angle);

}  // namespace taut::renderer
