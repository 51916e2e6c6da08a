#pragma once

#include <optional>
#include <span>

#include "app/viewer/state/orbit_camera.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// A point of the cloth under the pointer.
struct PickedPoint {
  sim::Index vertex = 0;  ///< corner of the triangle that is nearest to the point
  glm::dvec3 point_m{0.0};
  double distance_m = 0.0;  ///< from the eye
};

/// The nearest point where the ray meets a triangle, from either side; empty if it meets none. `positions`
/// are in metres, per vertex. It tests every triangle: ten thousand take 0.1 ms.
std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles);

/// Where the ray meets the plane through the point `through` that faces the camera. Empty if it does not meet
/// it.
std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through,
                                     const renderer::Camera& camera);

}  // namespace taut::app
