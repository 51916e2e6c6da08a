#include "renderer/primitives.hpp"

namespace taut::renderer {
namespace {

// Rings of a sphere around the axis `up`; the ring at the equator is doubled and moved apart by `axis`.
TriangleMesh rounded(const glm::vec3& a, const glm::vec3& axis, const glm::vec3& up, float radius_m, int segments) {
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
      const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
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

TriangleMesh make_sphere(const glm::vec3& centre, float radius_m, int segments) {
  return rounded(centre, glm::vec3{0.0F}, glm::vec3{0.0F, 1.0F, 0.0F}, radius_m, segments);
}

TriangleMesh make_capsule(const glm::vec3& a, const glm::vec3& b, float radius_m, int segments) {
  const glm::vec3 axis = b - a;
  const float length = glm::length(axis);
  if (!(length > 0.0F)) return make_sphere(a, radius_m, segments);
  return rounded(a, axis, axis / length, radius_m, segments);
}

void vertex_normals(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                    std::span<glm::vec3> normals, NormalWeight weight) {
  assert(normals.size() == positions.size());
  assert(triangles.size() % 3 == 0);
  std::ranges::fill(normals, glm::vec3{0.0F});
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
