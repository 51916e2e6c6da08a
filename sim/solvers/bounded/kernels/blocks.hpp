#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace taut::sim::bounded {

/// Number of springs, triangles or matrix rows in a block, for any width of the processor's vectors. Padding, selection
/// and division among threads are in whole blocks.
inline constexpr std::size_t block_size = 16;

/// Allocator that starts arrays on a cache line, so that no vector crosses two lines.
template <typename T> struct LineAligned {
  using value_type = T;
  static constexpr std::align_val_t line_bytes{64};

  LineAligned() = default;
  template <typename U> LineAligned(const LineAligned<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line_bytes)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, line_bytes); }
  bool operator==(const LineAligned&) const = default;
};

template <typename T>
/// Array from which kernels load vectors.
using Lanes = std::vector<T, LineAligned<T>>;

}  // namespace taut::sim::bounded
