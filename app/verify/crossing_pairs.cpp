#include "app/verify/crossing_pairs.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

struct TriangleBox {
  sim::Extent extent;
  sim::Index triangle = 0;
  bool is_of_body = false;
};

Corners triangle_corners(const sim::Surface& surface, const sim::Triangle& t) {
  return {surface.positions_m[t[0]], surface.positions_m[t[1]], surface.positions_m[t[2]]};
}

void require_place(const sim::Surface& surface, sim::Index triangle) {
  for (const sim::Index v : surface.triangles[triangle]) {
    if (!is_exactly_comparable(surface.positions_m[v])) {
      throw std::invalid_argument(
          fmt::format("triangle {}: found vertex {} at {}, expected finite coordinates below 1e100", triangle, v,
                      describe_point(surface.positions_m[v])));
    }
  }
}

void add_boxes(const sim::Surface& surface, bool is_of_body, std::vector<TriangleBox>& boxes) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    require_place(surface, static_cast<sim::Index>(t));
    const Corners corners = triangle_corners(surface, surface.triangles[t]);
    boxes.push_back({sim::compute_extent(corners), static_cast<sim::Index>(t), is_of_body});
  }
}

/// Equal intervals of an axis. A box belongs to each interval that it overlaps.
class Strips {
 public:
  /// Chooses the number of strips so that a strip is four boxes wide on average.
  Strips(std::span<const TriangleBox> boxes, double from, double length, int axis) : from_(from), axis_(axis) {
    double sum = 0.0;
    for (const TriangleBox& box : boxes) sum += box.extent.upper[axis] - box.extent.lower[axis];
    const double count = std::floor(length * static_cast<double>(boxes.size()) / (boxes_across * sum));
    // Boxes that are all one point get one strip.
    count_ = count >= 1.0 && count < max_strips ? static_cast<std::size_t>(count)
             : count >= max_strips              ? max_strips
                                                : 1;
    width_ = length / static_cast<double>(count_);
  }

  std::size_t count() const { return count_; }
  std::size_t of_lower(const TriangleBox& box) const { return at(box.extent.lower[axis_]); }
  std::size_t of_upper(const TriangleBox& box) const { return at(box.extent.upper[axis_]); }

 private:
  static constexpr double boxes_across = 4.0;
  static constexpr std::size_t max_strips = 1024;

  std::size_t at(double place) const {
    return count_ == 1 ? 0 : std::min(static_cast<std::size_t>(std::max((place - from_) / width_, 0.0)), count_ - 1);
  }

  double from_, width_ = 0.0;
  std::size_t count_ = 1;
  int axis_;
};

/// Calls `found` with all pairs of boxes that overlap, by sweep and prune (Baraff 1992). The sweep follows the axis of
/// the largest extent, where the fewest boxes are beside each other, in strips of the next largest.
template <class Found> void sweep(std::vector<TriangleBox>& boxes, const Found& found) {
  sim::Extent all;
  for (const TriangleBox& box : boxes) {
    all.add(box.extent.lower);
    all.add(box.extent.upper);
  }
  const sim::Vec3 size = all.size();
  std::array<int, 3> axes = {0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return size[a] > size[b]; });
  const int axis = axes[0];
  std::ranges::sort(boxes, [axis](const TriangleBox& a, const TriangleBox& b) {
    return a.extent.lower[axis] < b.extent.lower[axis];
  });
  const Strips strips(boxes, all.lower[axes[1]], size[axes[1]], axes[1]);
  std::vector<std::vector<const TriangleBox*>> in_strip(strips.count());
  for (const TriangleBox& box : boxes) {
    for (std::size_t s = strips.of_lower(box); s <= strips.of_upper(box); ++s) in_strip[s].push_back(&box);
  }
  for (std::size_t s = 0; s < in_strip.size(); ++s) {
    for (auto a = in_strip[s].begin(); a != in_strip[s].end(); ++a) {
      throw_if_interrupted();
      const double end = (*a)->extent.upper[axis];
      for (auto b = a + 1; b != in_strip[s].end() && (*b)->extent.lower[axis] <= end; ++b) {
        // Boxes that share several strips are reported in the first of them.
        if (sim::overlap((*a)->extent, (*b)->extent) && std::max(strips.of_lower(**a), strips.of_lower(**b)) == s) {
          found(**a, **b);
        }
      }
    }
  }
}

/// Reorders the corners of both so that shared ones come first, in the same order. Returns their number.
std::size_t bring_shared_to_front(sim::Triangle& a, sim::Triangle& b) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
    if (same != b.end()) {
      std::swap(a[shared], a[i]);
      std::iter_swap(b.begin() + static_cast<std::ptrdiff_t>(shared), same);
      ++shared;
    }
  }
  return shared;
}

std::optional<sim::Vec3> place_within(const sim::Surface& cloth, sim::Triangle a, sim::Triangle b) {
  const std::size_t shared = bring_shared_to_front(a, b);
  const auto place_of = shared == 0   ? crossing_place
                        : shared == 1 ? crossing_place_beside_vertex
                                      : crossing_place_beside_edge;
  return place_of(triangle_corners(cloth, a), triangle_corners(cloth, b));
}

std::vector<sim::CrossingPair> sort_pairs(std::vector<sim::CrossingPair> pairs) {
  std::ranges::sort(pairs, {}, [](const sim::CrossingPair& pair) { return std::pair(pair.first, pair.second); });
  return pairs;
}

using sim::Vec3;

/// Value and gradient of a convex function of points, below 0 inside a body.
struct Depth {
  double outside_m;
  Vec3 gradient;
};

Depth outside_ball(const Vec3& p, const Vec3& centre_m, double radius_m) {
  return {glm::distance(p, centre_m) - radius_m, sim::unit_or_zero(p - centre_m)};
}

/// Returns the depth inside the truncated cone between the two ends. The axis must have a length.
Depth outside_cone(const Vec3& p, const LimbShape& limb) {
  const Vec3 axis = limb.end_m - limb.start_m;
  const double length_m = glm::length(axis);
  const Vec3 along = axis / length_m;
  const double at_m = glm::dot(p - limb.start_m, along);
  if (at_m < 0.0) return {-at_m, -along};
  if (at_m > length_m) return {at_m - length_m, along};
  const double slope = (limb.end_radius_m - limb.start_radius_m) / length_m;
  const Vec3 across = p - limb.start_m - at_m * along;
  const Depth side = {glm::length(across) - limb.start_radius_m - slope * at_m,
                      sim::unit_or_zero(across) - slope * along};
  const Depth end = at_m > 0.5 * length_m ? Depth{at_m - length_m, along} : Depth{-at_m, -along};
  return side.outside_m > end.outside_m ? side : end;
}

/// Returns whether the function goes below -max_depth_m in the triangle. It is nowhere below its tangents, so that the
/// smallest value of a tangent at the corners is a bound. Where the bound does not decide, the triangle is halved.
template <class Outside> bool enters(const Corners& t, const Outside& outside) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const Depth here = outside(middle);
  if (here.outside_m < -max_depth_m) return true;
  double rises_m = 0.0;
  for (const Vec3& corner : t) rises_m = std::min(rises_m, glm::dot(here.gradient, corner - middle));
  if (here.outside_m + rises_m >= -max_depth_m || rises_m > -1e-3 * max_depth_m) return false;
  const auto length = [&](std::size_t k) { return glm::distance(t[k], t[(k + 1) % 3]); };
  const std::size_t long_axis = length(0) >= length(1) && length(0) >= length(2) ? 0 : length(1) >= length(2) ? 1 : 2;
  const Vec3 &from = t[long_axis], &to = t[(long_axis + 1) % 3], &tip = t[(long_axis + 2) % 3];
  const Vec3 half = 0.5 * (from + to);
  return enters(Corners{from, half, tip}, outside) || enters(Corners{half, to, tip}, outside);
}

}  // namespace

std::vector<sim::CrossingPair> crossing_pairs(const sim::Surface& cloth) {
  std::vector<TriangleBox> boxes;
  add_boxes(cloth, false, boxes);
  std::vector<sim::CrossingPair> pairs;
  sweep(boxes, [&](const TriangleBox& a, const TriangleBox& b) {
    const auto [first, second] = std::minmax(a.triangle, b.triangle);
    if (const auto place = place_within(cloth, cloth.triangles[first], cloth.triangles[second])) {
      pairs.push_back({first, second, *place});
    }
  });
  return sort_pairs(std::move(pairs));
}

std::vector<sim::CrossingPair> crossing_pairs(const sim::Surface& cloth, const sim::Surface& body) {
  std::vector<TriangleBox> boxes;
  add_boxes(cloth, false, boxes);
  add_boxes(body, true, boxes);
  std::vector<sim::CrossingPair> pairs;
  sweep(boxes, [&](const TriangleBox& a, const TriangleBox& b) {
    if (a.is_of_body == b.is_of_body) return;
    const sim::Index first = a.is_of_body ? b.triangle : a.triangle;
    const sim::Index second = a.is_of_body ? a.triangle : b.triangle;
    if (const auto place = crossing_place(triangle_corners(cloth, cloth.triangles[first]),
                                          triangle_corners(body, body.triangles[second]))) {
      pairs.push_back({first, second, *place});
    }
  });
  return sort_pairs(std::move(pairs));
}

bool enters_half_space(const Corners& triangle, const Vec3& point_m, const Vec3& normal) {
  return std::ranges::any_of(triangle,
                             [&](const Vec3& corner) { return glm::dot(corner - point_m, normal) < -max_depth_m; });
}

bool enters_limb(const Corners& triangle, const LimbShape& limb) {
  if (enters(triangle, [&](const Vec3& p) { return outside_ball(p, limb.start_m, limb.start_radius_m); })) return true;
  return limb.start_m != limb.end_m &&
         (enters(triangle, [&](const Vec3& p) { return outside_ball(p, limb.end_m, limb.end_radius_m); }) ||
          enters(triangle, [&](const Vec3& p) { return outside_cone(p, limb); }));
}

}  // namespace taut::app
