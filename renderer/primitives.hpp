#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// A triangle mesh that owns its arrays, for bodies and pins. n = number of vertices = positions.size().
struct TriangleMesh {
  std::vector<glm::vec3> positions;      ///< n, metres
  std::vector<glm::vec3> normals;        ///< n, of unit length, pointing outside
  std::vector<std::uint32_t> triangles;  ///< three vertex indices each, counter-clockwise seen from outside
};

/// Returns a sphere of latitude rings. `segments`: vertices per ring, at least 3; there are half as many
/// rings.
TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments = 48);
/// Returns a cylinder from a to b (metres) with half spheres on its ends; a sphere when a equals b.
/// `segments` as in make_sphere.
TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments = 48);

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
