#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/blocks.hpp"

namespace taut::sim::bounded {

/// Three coordinates of one vertex and a fourth number, 0 unless said otherwise. Processors load and store four floats
/// at once. The fourth is computed like the others, so that the compiler uses one vector instruction for all.
struct Float4 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float fourth = 0.0F;
};

/// Returns the same memory as floats, four per entry.
inline float* as_floats(Float4* values) { return reinterpret_cast<float*>(values); }
inline const float* as_floats(const Float4* values) { return reinterpret_cast<const float*>(values); }

/// One entry per solver index; see Layout.
using Float4Array = Lanes<Float4>;

/// Returns the vector rounded to single precision.
inline Float4 to_float4(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F};
}

/// Does sum += factor * x.
inline void add_scaled(Float4& sum, const Float4& x, float factor) {
  sum.x += factor * x.x;
  sum.y += factor * x.y;
  sum.z += factor * x.z;
  sum.fourth += factor * x.fourth;
}

/// Returns a + factor b.
inline Float4 scaled_sum(const Float4& a, const Float4& b, float factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z, a.fourth + factor * b.fourth};
}

/// Returns the exact coordinates: every float is a double.
inline Vec3 to_vec3(const Float4& v) { return {v.x, v.y, v.z}; }

inline float vector_length(const Float4& v) { return static_cast<float>(glm::length(to_vec3(v))); }

inline Float4 multiply(const Float4& v, float factor) { return {v.x * factor, v.y * factor, v.z * factor, 0.0F}; }

/// Returns v, shortened to `most` if it is longer.
inline Float4 limit_length(float most, const Float4& v) {
  return multiply(v, std::min(1.0F, most / std::max(vector_length(v), 1e-12F)));
}

inline float dot(const Float4& a, const Float4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Returns the first three numbers.
inline glm::vec3 vec(const Float4& v) { return {v.x, v.y, v.z}; }

/// Does sum += v.
inline void add(Float4& sum, const glm::vec3& v) {
  sum.x += v.x;
  sum.y += v.y;
  sum.z += v.z;
}

}  // namespace taut::sim::bounded
