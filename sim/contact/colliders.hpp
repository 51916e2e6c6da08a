#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// A half space. Cloth stays on the side that the normal points to.
struct Plane {
  Vec3 point_m = {0.0, 0.0, 0.0};
  Vec3 normal = {0.0, 1.0, 0.0};  ///< of length 1

  bool operator==(const Plane&) const = default;
};

/// Cloth stays outside.
struct Sphere {
  Vec3 centre_m = {0.0, 0.0, 0.0};
  double radius_m = 0.1;

  bool operator==(const Sphere&) const = default;
};

/// A limb: all points near a segment. The radius changes linearly from one end of the segment to the other.
struct Capsule {
  Vec3 start_m = {0.0, 0.0, 0.0};
  Vec3 end_m = {0.0, 1.0, 0.0};
  double start_radius_m = 0.1;
  double end_radius_m = 0.1;

  bool operator==(const Capsule&) const = default;
};

using Shape = std::variant<Plane, Sphere, Capsule>;

/// A body that the cloth cannot enter.
struct Collider {
  Shape shape;
  /// Coulomb's coefficient. Without it, the cloth's own is used.
  std::optional<double> friction = {};

  bool operator==(const Collider&) const = default;
};

/// A point on the surface of a shape, seen from another point.
struct SurfacePoint {
  double distance_m;  ///< from the surface, negative inside
  Vec3 normal;        ///< of length 1, outwards
};

/// Returns the point of the shape's surface that is nearest to `point`, as distance and normal. On a tapered
/// capsule it is found at right angles to the axis, so that the distance can be slightly larger than the true
/// one.
SurfacePoint nearest_surface(const Shape& shape, const Vec3& point);

/// The properties of the cloth that contact with colliders depends on.
struct ClothSurface {
  double thickness_m = 0.0;  ///< the distance kept between cloth and colliders
  double friction = 0.0;     ///< Coulomb's coefficient for colliders that have none of their own
};

/// Moves every free vertex that is predicted closer to a shape than the cloth's thickness out along the
/// normal. Friction then takes back its sliding since p(t), up to mu times the depth it was pushed (Coulomb's
/// law for positions; Mueller, Heidelberger, Hennix and Ratcliff 2007). Positions are in metres. All spans
/// but `colliders` have one entry per vertex.
void push_out_of_colliders(std::span<const Collider> colliders, const ClothSurface& cloth,
                           std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                           std::span<Vec3> predicted);

}  // namespace taut::sim
