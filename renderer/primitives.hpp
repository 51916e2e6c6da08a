#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace taut::renderer {

/// Triangles that own their arrays, for things that are not cloth: colliders, stands, pins.
struct TriangleMesh {
  std::vector<glm::vec3> positions;      ///< metres
  std::vector<glm::vec3> normals;        ///< unit, one for each position
  std::vector<std::uint32_t> triangles;  ///< three indices each, counter-clockwise seen from outside
};

/// `segments` counts around the axis, at least 3; half as many are used from pole to pole.
TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments = 48);
/// A cylinder from a to b with half spheres on its ends.
TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments = 48);

}  // namespace taut::renderer
