#include "app/verify/solid_bodies.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

/// The value and the gradient of a convex function of points, below 0 inside a body.
struct Depth {
  double outside_m;
  Vec3 gradient;
};

Vec3 direction_of(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3(0.0);
}

Depth outside_ball(const Vec3& p, const Vec3& centre_m, double radius_m) {
  return {glm::distance(p, centre_m) - radius_m, direction_of(p - centre_m)};
}

/// Returns the depth below the cone between the two ends. The axis must have a length.
Depth outside_cone(const Vec3& p, const Limb& limb) {
  const Vec3 axis = limb.end_m - limb.start_m;
  const double length_m = glm::length(axis);
  const Vec3 along = axis / length_m;
  const double at_m = glm::dot(p - limb.start_m, along);
  if (at_m < 0.0) return {-at_m, -along};
  if (at_m > length_m) return {at_m - length_m, along};
  const double slope = (limb.end_radius_m - limb.start_radius_m) / length_m;
  const Vec3 across = p - limb.start_m - at_m * along;
  const Depth side = {glm::length(across) - limb.start_radius_m - slope * at_m, direction_of(across) - slope * along};
  const Depth end = at_m > 0.5 * length_m ? Depth{at_m - length_m, along} : Depth{-at_m, -along};
  return side.outside_m > end.outside_m ? side : end;
}

/// Whether the function goes below -most_depth_m in the triangle. It is nowhere below its tangents, so that
/// the smallest of a tangent at the corners is a bound; where that does not tell, the triangle is halved.
template <class Outside> bool enters(const Corners& t, const Outside& outside) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const Depth here = outside(middle);
  if (here.outside_m < -most_depth_m) return true;
  double rises_m = 0.0;
  for (const Vec3& corner : t) rises_m = std::min(rises_m, glm::dot(here.gradient, corner - middle));
  if (here.outside_m + rises_m >= -most_depth_m || rises_m > -1e-3 * most_depth_m) return false;
  const auto length = [&](std::size_t k) { return glm::distance(t[k], t[(k + 1) % 3]); };
  const std::size_t longest = length(0) >= length(1) && length(0) >= length(2) ? 0 : length(1) >= length(2) ? 1 : 2;
  const Vec3 &from = t[longest], &to = t[(longest + 1) % 3], &tip = t[(longest + 2) % 3];
  const Vec3 half = 0.5 * (from + to);
  return enters(Corners{from, half, tip}, outside) || enters(Corners{half, to, tip}, outside);
}

}  // namespace

bool enters_half_space(const Corners& triangle, const Vec3& point_m, const Vec3& normal) {
  return std::ranges::any_of(triangle,
                             [&](const Vec3& corner) { return glm::dot(corner - point_m, normal) < -most_depth_m; });
}

bool enters_limb(const Corners& triangle, const Limb& limb) {
  if (enters(triangle, [&](const Vec3& p) { return outside_ball(p, limb.start_m, limb.start_radius_m); })) {
    return true;
  }
  return limb.start_m != limb.end_m &&
         (enters(triangle, [&](const Vec3& p) { return outside_ball(p, limb.end_m, limb.end_radius_m); }) ||
          enters(triangle, [&](const Vec3& p) { return outside_cone(p, limb); }));
}

double winding_number(const Vec3& point_m, const Surface& surface) {
  double half_angles = 0.0;
  for (const sim::Triangle& t : surface.triangles) {
    const Vec3 a = surface.positions_m[t[0]] - point_m;
    const Vec3 b = surface.positions_m[t[1]] - point_m;
    const Vec3 c = surface.positions_m[t[2]] - point_m;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    half_angles += std::atan2(glm::dot(a, glm::cross(b, c)),
                              la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return half_angles / (2.0 * std::numbers::pi);
}

}  // namespace taut::app
