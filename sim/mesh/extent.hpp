#pragma once

#include <glm/common.hpp>
#include <limits>
#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The smallest box along the axes that holds points. Without any it is inside out: infinite, its size
/// negative.
struct Extent {
  Vec3 lower = Vec3(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;

  void add(const Vec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  Vec3 size() const { return upper - lower; }
};

inline Extent extent_of(std::span<const Vec3> points) {
  Extent extent;
  for (const Vec3& point : points) {
    extent.add(point);
  }
  return extent;
}

}  // namespace taut::sim
