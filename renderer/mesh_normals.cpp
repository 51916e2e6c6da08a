#include "renderer/mesh_normals.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

float angle_between(const glm::vec3& a, const glm::vec3& b) {
  // atan2 keeps its precision for needles, where the arc cosine loses it.
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void add_triangle(const std::array<std::uint32_t, 3>& corners, std::span<const glm::vec3> positions,
                  std::span<glm::vec3> normals, NormalWeight weight) {
  const std::array p{positions[corners[0]], positions[corners[1]], positions[corners[2]]};
  const glm::vec3 twice_area = glm::cross(p[1] - p[0], p[2] - p[0]);
  const float length = glm::length(twice_area);
  if (!(length > 0.0F && std::isfinite(length))) return;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weight == NormalWeight::area) {
      normals[corners[i]] += twice_area;
    } else {
      const float angle = angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
      normals[corners[i]] += twice_area * (angle / length);
    }
  }
}

}  // namespace

void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals, NormalWeight weight) {
  assert(normals.size() == positions.size());
  assert(triangles.size() % 3 == 0);
  std::fill(normals.begin(), normals.end(), glm::vec3{0.0F});
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    assert(std::max({triangles[i], triangles[i + 1], triangles[i + 2]}) < positions.size());
    add_triangle({triangles[i], triangles[i + 1], triangles[i + 2]}, positions, normals, weight);
  }
  for (glm::vec3& normal : normals) {
    const float length = glm::length(normal);
    normal = length > 0.0F && std::isfinite(length) ? normal / length : glm::vec3{0.0F, 1.0F, 0.0F};
  }
}

}  // namespace taut::renderer
