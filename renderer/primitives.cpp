#include "renderer/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace taut::renderer {

namespace {

// Rings of a sphere around the axis `up`; the ring at the equator is doubled and moved apart by `axis`.
TriangleMesh rounded(const glm::vec3& a, const glm::vec3& axis, const glm::vec3& up, float radius_m,
                     int segments) {
  const int around = std::max(segments, 3);
  const int half_rings = std::max(around / 4, 1);
  const glm::vec3 other = std::abs(up.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
  const glm::vec3 side = glm::normalize(glm::cross(other, up));
  const glm::vec3 forward = glm::cross(side, up);
  TriangleMesh mesh;
  for (int ring = 0; ring <= 2 * half_rings + 1; ++ring) {
    const bool upper = ring > half_rings;
    const int step = upper ? ring - 1 : ring;
    const float latitude =
        std::numbers::pi_v<float> * (static_cast<float>(step) / static_cast<float>(2 * half_rings) - 0.5F);
    for (int i = 0; i < around; ++i) {
      const float turn =
          2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
      const glm::vec3 normal =
          std::cos(latitude) * (std::cos(turn) * side + std::sin(turn) * forward) + std::sin(latitude) * up;
      mesh.normals.push_back(normal);
      mesh.positions.push_back(a + (upper ? axis : glm::vec3{0.0F}) + radius_m * normal);
    }
  }
  for (int ring = 0; ring <= 2 * half_rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const auto p = static_cast<std::uint32_t>(ring * around + i);
      const auto q = static_cast<std::uint32_t>(ring * around + (i + 1) % around);
      const auto row = static_cast<std::uint32_t>(around);
      mesh.triangles.insert(mesh.triangles.end(), {p, p + row, q, q, p + row, q + row});
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments) {
  return rounded(centre, glm::vec3{0.0F}, glm::vec3{0.0F, 1.0F, 0.0F}, radius_m, segments);
}

TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments) {
  const glm::vec3 axis = b - a;
  const float length = glm::length(axis);
  if (!(length > 0.0F)) return make_sphere(a, radius_m, segments);
  return rounded(a, axis, axis / length, radius_m, segments);
}

}  // namespace taut::renderer
