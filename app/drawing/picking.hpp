#pragma once

#include "sim/mesh/types.hpp"

namespace taut::app {

/// A ray in the scene. `direction` has unit length.
struct Ray {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};
};

/// A point of the cloth under the pointer.
struct PickedPoint {
  sim::Index vertex = 0;  ///< corner of the triangle that is nearest to the point
  glm::dvec3 point_m{0.0};
  double distance_m = 0.0;  ///< distance from the eye
};

/// Returns the nearest intersection of the ray with a triangle, from either side; empty if there is none. `positions`:
/// metres, per vertex. It tests every triangle: ten thousand take 0.1 ms.
std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles);

}  // namespace taut::app
