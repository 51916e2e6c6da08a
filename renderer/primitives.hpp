#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

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

}  // namespace taut::renderer
