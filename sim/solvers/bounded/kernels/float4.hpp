#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/blocks.hpp"

namespace taut::sim::bounded {

/// The three coordinates of one vertex and a fourth number, which is 0 where nothing else is said of it. Processors
/// load and store four floats at once. The fourth is computed like the others, so that the compiler uses one vector
/// instruction for all.
struct Float4 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float fourth = 0.0F;
};

/// The same values as single floats, four per row.
inline float* floats_of(Float4* values) { return reinterpret_cast<float*>(values); }
inline const float* floats_of(const Float4* values) { return reinterpret_cast<const float*>(values); }

/// One entry per row of the layout; see Layout.
using Float4Array = Lanes<Float4>;

/// Rounds to single precision.
inline Float4 float4_of(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F};
}

/// sum += factor * x.
inline void add_scaled(Float4& sum, const Float4& x, float factor) {
  sum.x += factor * x.x;
  sum.y += factor * x.y;
  sum.z += factor * x.z;
  sum.fourth += factor * x.fourth;
}

/// a + factor b.
inline Float4 scaled_sum(const Float4& a, const Float4& b, float factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z, a.fourth + factor * b.fourth};
}

/// Exact: every float is a double.
inline Vec3 vector_of(const Float4& v) { return {v.x, v.y, v.z}; }

inline float length_of(const Float4& v) { return static_cast<float>(glm::length(vector_of(v))); }

inline Float4 times(const Float4& v, float factor) { return {v.x * factor, v.y * factor, v.z * factor, 0.0F}; }

/// Returns v, shortened where it is longer.
inline Float4 no_longer_than(float most, const Float4& v) {
  return times(v, std::min(1.0F, most / std::max(length_of(v), 1e-12F)));
}

inline float dot(const Float4& a, const Float4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The same three numbers.
inline glm::vec3 vec(const Float4& v) { return {v.x, v.y, v.z}; }

/// sum += v.
inline void add(Float4& sum, const glm::vec3& v) {
  sum.x += v.x;
  sum.y += v.y;
  sum.z += v.z;
}

}  // namespace taut::sim::bounded
