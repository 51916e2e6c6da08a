#pragma once

#include <cstdint>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// Three vertices for each triangle.
inline std::vector<std::uint32_t> flat(const std::vector<sim::Triangle>& triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangles.size() * 3);
  for (const sim::Triangle& t : triangles) {
    indices.insert(indices.end(), t.begin(), t.end());
  }
  return indices;
}

}  // namespace taut::app
