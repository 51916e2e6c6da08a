#include "sim/contact/shape_distance.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace taut::sim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Each leaves 0.62 of the axis of a capsule: all together as much of it as double precision tells apart.
constexpr int most_cuts = 40;

/// The least value of a convex function between 0 and 1, by golden sections.
template <typename Function>
double least_of(const Function& f) {
  constexpr double part = 1.0 / std::numbers::phi;
  double from = 0.0, to = 1.0;
  double low = 1.0 - part, high = part;
  double at_low = f(low), at_high = f(high);
  for (int cut = 0; cut < most_cuts; ++cut) {
    if (at_low < at_high) {
      to = high;
      high = low;
      at_high = at_low;
      low = to - part * (to - from);
      at_low = f(low);
    } else {
      from = low;
      low = high;
      at_low = at_high;
      high = from + part * (to - from);
      at_high = f(high);
    }
  }
  return std::min({f(0.0), at_low, at_high, f(1.0)});
}

double limb_distance_m(const Corners& t, const Capsule& limb, double reach_m) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const double size_m =
      std::max({glm::distance(middle, t[0]), glm::distance(middle, t[1]), glm::distance(middle, t[2])});
  const auto centre = [&](double along) { return glm::mix(limb.start_m, limb.end_m, along); };
  const auto radius_m = [&](double along) { return glm::mix(limb.start_radius_m, limb.end_radius_m, along); };
  const double outer_m =
      0.5 * glm::distance(limb.start_m, limb.end_m) + std::max(limb.start_radius_m, limb.end_radius_m);
  if (glm::distance(centre(0.5), middle) > outer_m + size_m + reach_m) {
    return infinity;
  }
  const auto from_middle = [&](double along) { return glm::distance(centre(along), middle) - radius_m(along); };
  if (least_of(from_middle) > size_m + reach_m) {
    return infinity;
  }
  return least_of([&](double along) { return point_triangle_distance_m(centre(along), t) - radius_m(along); });
}

struct Distance {
  const Corners& t;
  double reach_m;

  double operator()(const Plane& plane) const {
    const auto height_m = [&](const Vec3& corner) { return glm::dot(corner - plane.point_m, plane.normal); };
    return std::min({height_m(t[0]), height_m(t[1]), height_m(t[2])});
  }
  double operator()(const Sphere& ball) const {
    return point_triangle_distance_m(ball.centre_m, t) - ball.radius_m;
  }
  double operator()(const Capsule& limb) const { return limb_distance_m(t, limb, reach_m); }
  double operator()(const BodyMesh&) const { return infinity; }
};

}  // namespace

double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m) {
  const double distance_m = std::visit(Distance{triangle, reach_m}, shape);
  return distance_m <= reach_m ? distance_m : infinity;
}

}  // namespace taut::sim
