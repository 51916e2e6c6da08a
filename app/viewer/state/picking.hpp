#pragma once

#include <optional>
#include <span>

#include "app/viewer/state/orbit_camera.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// The point of the cloth that is under the pointer.
struct PickedPoint {
  sim::Index vertex = 0;  ///< the corner nearest to the point
  glm::dvec3 point_m{0.0};
  double distance_m = 0.0;  ///< from the eye
};

/// The nearest of all triangles that the ray meets, from either side. Looks at every triangle: ten thousand
/// take a tenth of a millisecond.
std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles);

/// Where the ray meets the plane through a point that faces the camera; nothing where it does not.
std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through,
                                     const renderer::Camera& camera);

}  // namespace taut::app
