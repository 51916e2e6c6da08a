#pragma once

#include <glm/vector_relational.hpp>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The smallest axis-aligned box around some points. Without points its lower corner is +infinity and its
/// upper corner -infinity.
struct Extent {
  Vec3 lower = Vec3(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;

  void add(const Vec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  Vec3 size() const { return upper - lower; }
  Vec3 middle() const { return 0.5 * (lower + upper); }
};

/// Returns the extent of these points, in their unit.
inline Extent compute_extent(std::span<const Vec3> points) {
  Extent extent;
  for (const Vec3& point : points) extent.add(point);
  return extent;
}

/// Returns the extent of the points with these indices.
inline Extent compute_extent(std::span<const Vec3> points, std::span<const Index> listed) {
  Extent extent;
  for (const Index k : listed) extent.add(points[k]);
  return extent;
}

/// Returns whether two extents have a point in common.
inline bool overlap(const Extent& a, const Extent& b) {
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// Returns the index of the longest axis, the first of equal ones.
inline int long_axis(const Extent& extent) {
  const Vec3 size = extent.size();
  return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

}  // namespace taut::sim
