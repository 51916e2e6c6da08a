#pragma once

#include <cstddef>
#include <new>
#include <vector>

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

}  // namespace taut::sim::bounded
