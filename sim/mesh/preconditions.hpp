#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Conditions of asserts.

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Returns whether each index of the edges, triangles or other primitives is below `count`.
template <class Primitives> bool are_below(const Primitives& primitives, std::size_t count) {
  for (const auto& primitive : primitives) {
    for (const Index index : primitive) {
      if (index >= count) return false;
    }
  }
  return true;
}

}  // namespace taut::sim
