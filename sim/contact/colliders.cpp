#include "sim/contact/colliders.hpp"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

namespace taut::sim {
namespace {

SurfacePoint from_centre(const Vec3& centre, double radius_m, const Vec3& point) {
  const Vec3 outwards = point - centre;
  const double length = glm::length(outwards);
  // At the centre every way out is equally short; up is as good as any.
  const Vec3 normal = length > 0.0 ? outwards / length : Vec3(0.0, 1.0, 0.0);
  return {length - radius_m, normal};
}

SurfacePoint nearest(const Plane& plane, const Vec3& point) {
  return {glm::dot(point - plane.point_m, plane.normal), plane.normal};
}

SurfacePoint nearest(const Sphere& sphere, const Vec3& point) {
  return from_centre(sphere.centre_m, sphere.radius_m, point);
}

SurfacePoint nearest(const Capsule& capsule, const Vec3& point) {
  const Vec3 axis = capsule.end_m - capsule.start_m;
  const double squared_length = glm::dot(axis, axis);
  const double along = squared_length > 0.0
                           ? std::clamp(glm::dot(point - capsule.start_m, axis) / squared_length, 0.0, 1.0)
                           : 0.0;
  const double radius_m = capsule.start_radius_m + along * (capsule.end_radius_m - capsule.start_radius_m);
  return from_centre(capsule.start_m + along * axis, radius_m, point);
}

Vec3 with_friction(double friction, const SurfacePoint& surface, double depth_m, const Vec3& from,
                   const Vec3& pushed_out) {
  const Vec3 moved = pushed_out - from;
  const Vec3 slid = moved - surface.normal * glm::dot(moved, surface.normal);
  const double slid_m = glm::length(slid);
  if (!(slid_m > 0.0)) {
    return pushed_out;
  }
  return pushed_out - slid * std::min(1.0, friction * depth_m / slid_m);
}

}  // namespace

SurfacePoint nearest_surface(const Shape& shape, const Vec3& point) {
  return std::visit([&](const auto& s) { return nearest(s, point); }, shape);
}

void push_out_of_colliders(std::span<const Collider> colliders, const ClothSurface& cloth,
                           std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                           std::span<Vec3> predicted) {
  assert(current.size() == predicted.size() && inverse_masses_per_kg.size() == predicted.size());
  for (const Collider& collider : colliders) {
    const double friction = collider.friction.value_or(cloth.friction);
    for (std::size_t v = 0; v < predicted.size(); ++v) {
      if (inverse_masses_per_kg[v] == 0.0) {
        continue;
      }
      const SurfacePoint surface = nearest_surface(collider.shape, predicted[v]);
      const double depth_m = cloth.thickness_m - surface.distance_m;
      if (depth_m > 0.0) {
        const Vec3 pushed_out = predicted[v] + surface.normal * depth_m;
        predicted[v] = with_friction(friction, surface, depth_m, current[v], pushed_out);
      }
    }
  }
}

}  // namespace taut::sim
