#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim::bounded {

/// Springs, triangles or rows of a matrix are worked on in blocks of this many, whatever number the
/// processor's vectors hold: a block is the unit of padding, of choosing and of sharing work among threads.
inline constexpr std::size_t block_size = 16;

/// Starts arrays on a cache line, so that no vector of them lies on two.
template <typename T>
struct LineAligned {
  using value_type = T;
  static constexpr std::align_val_t line_bytes{64};

  LineAligned() = default;
  template <typename U>
  LineAligned(const LineAligned<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line_bytes)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, line_bytes); }
  bool operator==(const LineAligned&) const = default;
};

template <typename T>
using Lanes = std::vector<T, LineAligned<T>>;

/// Three coordinates of one vertex and an unused fourth, always 0: one load, one store. What is done to three
/// is done to the fourth, so that a compiler does it to all at once.
struct Row {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float unused = 0.0F;
};

using Rows = Lanes<Row>;

inline Row row_of(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F};
}

inline void add_scaled(Row& sum, const Row& r, float factor) {
  sum.x += factor * r.x;
  sum.y += factor * r.y;
  sum.z += factor * r.z;
  sum.unused += factor * r.unused;
}

/// a + factor b.
inline Row scaled_sum(const Row& a, const Row& b, float factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z, a.unused + factor * b.unused};
}

inline Vec3 vector_of(const Row& r) {
  return {r.x, r.y, r.z};
}

}  // namespace taut::sim::bounded
