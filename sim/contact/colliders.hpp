#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Cloth stays on the side the normal points to.
struct Plane {
  Vec3 point_m = {0.0, 0.0, 0.0};
  Vec3 normal = {0.0, 1.0, 0.0};  ///< of length 1

  bool operator==(const Plane&) const = default;
};

struct Sphere {
  Vec3 centre_m = {0.0, 0.0, 0.0};
  double radius_m = 0.1;

  bool operator==(const Sphere&) const = default;
};

/// All points within a radius of a segment; the radius goes linearly from one end to the other, as in a
/// limb.
struct Capsule {
  Vec3 start_m = {0.0, 0.0, 0.0};
  Vec3 end_m = {0.0, 1.0, 0.0};
  double start_radius_m = 0.1;
  double end_radius_m = 0.1;

  bool operator==(const Capsule&) const = default;
};

using Shape = std::variant<Plane, Sphere, Capsule>;

struct Collider {
  Shape shape;
  std::optional<double> friction = {};  ///< Coulomb's coefficient; none: the cloth's

  bool operator==(const Collider&) const = default;
};

struct SurfacePoint {
  double distance_m;  ///< to the surface, negative inside
  Vec3 normal;        ///< of length 1, outwards
};

/// The point of the shape's surface nearest to `point`, as distance and normal. For a tapered capsule the
/// distance is measured at right angles to its axis, which never exceeds the true one's sphere sweep.
SurfacePoint nearest_surface(const Shape& shape, const Vec3& point);

/// What of the cloth its contact with colliders depends on.
struct ClothSurface {
  double thickness_m = 0.0;  ///< kept between cloth and colliders
  double friction = 0.0;     ///< Coulomb's coefficient, where a collider has none of its own
};

/// Moves every free vertex that is predicted to be closer than the cloth is thick to a shape out along the
/// normal, and takes back as much of its sliding since p(t) as friction allows: mu times the depth it was
/// pushed (Coulomb's law on positions; Mueller, Heidelberger, Hennix and Ratcliff 2007).
void push_out_of_colliders(std::span<const Collider> colliders, const ClothSurface& cloth,
                           std::span<const double> inverse_masses_per_kg, std::span<const Vec3> current,
                           std::span<Vec3> predicted);

}  // namespace taut::sim
