#include "app/drawing/picking.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>

namespace taut::app {

std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles) {
  const glm::dvec3 origin(ray.origin);
  const glm::dvec3 direction(ray.direction);
  std::optional<PickedPoint> nearest_point;
  for (const sim::Triangle& t : triangles) {
    glm::dvec2 weights;
    double distance_m = 0.0;
    const bool is_met = glm::intersectRayTriangle(origin, direction, positions[t[0]], positions[t[1]], positions[t[2]],
                                                  weights, distance_m);
    const bool is_ahead = is_met && distance_m > 0.0 && std::isfinite(distance_m);
    if (is_ahead && (!nearest_point || distance_m < nearest_point->distance_m)) {
      const glm::dvec3 w(1.0 - weights.x - weights.y, weights.x, weights.y);
      const int corner = w.x >= w.y && w.x >= w.z ? 0 : (w.y >= w.z ? 1 : 2);
      nearest_point = {t[static_cast<std::size_t>(corner)], origin + distance_m * direction, distance_m};
    }
  }
  return nearest_point;
}

}  // namespace taut::app
