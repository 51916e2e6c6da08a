#include "app/viewer/state/picking.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace taut::app {
namespace {

struct Hit {
  double distance_m = 0.0;
  glm::dvec3 weights{0.0};  // of the three corners
};

// Moeller and Trumbore 1997.
std::optional<Hit> meet(const glm::dvec3& origin, const glm::dvec3& direction, const sim::Vec3& a,
                        const sim::Vec3& b, const sim::Vec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) {
    return std::nullopt;
  }
  const glm::dvec3 from_a = origin - a;
  const double u = glm::dot(from_a, p) / determinant;
  const glm::dvec3 q = glm::cross(from_a, ab);
  const double v = glm::dot(direction, q) / determinant;
  const double distance = glm::dot(ac, q) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && std::isfinite(distance))) {
    return std::nullopt;
  }
  return Hit{distance, {1.0 - u - v, u, v}};
}

}  // namespace

std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles) {
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  std::optional<PickedPoint> nearest;
  for (const sim::Triangle& t : triangles) {
    const auto hit = meet(origin, direction, positions[t[0]], positions[t[1]], positions[t[2]]);
    if (hit && (!nearest || hit->distance_m < nearest->distance_m)) {
      const glm::dvec3& w = hit->weights;
      const int corner = w.x >= w.y && w.x >= w.z ? 0 : (w.y >= w.z ? 1 : 2);
      nearest = {t[static_cast<std::size_t>(corner)], origin + hit->distance_m * direction, hit->distance_m};
    }
  }
  return nearest;
}

std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through,
                                     const renderer::Camera& camera) {
  const glm::dvec3 facing(glm::normalize(camera.target - camera.eye));
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  const double slant = glm::dot(direction, facing);
  const double distance = glm::dot(through - origin, facing) / slant;
  if (!(slant > 1e-6) || !std::isfinite(distance) || distance <= 0.0) {
    return std::nullopt;
  }
  return origin + distance * direction;
}

}  // namespace taut::app
