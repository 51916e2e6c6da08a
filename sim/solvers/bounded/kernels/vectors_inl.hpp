// Vectors for the target being compiled: loads entries (four floats each), transposes them to coordinates and stores
// them again. The file is included once per target, so its include guard is of another kind.
#if defined(TAUT_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_VECTORS_INL
#undef TAUT_VECTORS_INL
#else
#define TAUT_VECTORS_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "sim/solvers/bounded/kernels/blocks.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using FourFloats = hn::FixedTag<float, 4>;
using Floats = hn::CappedTag<float, block_size>;
using V = hn::Vec<Floats>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());

/// Prefetches data needed soon. Even cached data is waited for if the processor does not foresee the access.
template <typename T> HWY_INLINE void fetch(const T& what) {
  constexpr auto line_bytes = static_cast<std::size_t>(LineAligned<T>::line_bytes);
  const char* const bytes = reinterpret_cast<const char*>(&what);
  for (std::size_t at = 0; at < sizeof(T); at += line_bytes) hwy::Prefetch(bytes + at);
}

/// Four vectors: loaded entries, or one coordinate each.
struct Four {
  V a, b, c, d;
};

/// Turns entries into coordinates and back: transposes the 4x4 matrix in every 128 bits.
HWY_INLINE Four transpose(const Four& m) {
  const Floats f;
  const V ac_low = hn::InterleaveLower(f, m.a, m.c);
  const V bd_low = hn::InterleaveLower(f, m.b, m.d);
  const V ac_high = hn::InterleaveUpper(f, m.a, m.c);
  const V bd_high = hn::InterleaveUpper(f, m.b, m.d);
  return {hn::InterleaveLower(f, ac_low, bd_low), hn::InterleaveUpper(f, ac_low, bd_low),
          hn::InterleaveLower(f, ac_high, bd_high), hn::InterleaveUpper(f, ac_high, bd_high)};
}

/// Loads the entries at the float offsets at[0], at[4], ..., side by side.
template <std::size_t count> HWY_INLINE auto load_every_fourth(const float* rows, const std::uint32_t* at) {
  if constexpr (count == 4) {
    return hn::Load(FourFloats(), rows + at[0]);
  } else {
    return hn::Combine(hn::FixedTag<float, count>(), load_every_fourth<count / 2>(rows, at + count / 2),
                       load_every_fourth<count / 2>(rows, at));
  }
}

template <std::size_t count, typename Vector>
HWY_INLINE void store_every_fourth(Vector v, float* rows, const std::uint32_t* at) {
  if constexpr (count == 4) {
    hn::Store(v, FourFloats(), rows + at[0]);
  } else {
    const hn::FixedTag<float, count / 2> half;
    store_every_fourth<count / 2>(hn::LowerHalf(half, v), rows, at);
    store_every_fourth<count / 2>(hn::UpperHalf(half, v), rows, at + count / 2);
  }
}

HWY_INLINE Four load_rows(const float* rows, const std::uint32_t* at) {
  return {load_every_fourth<lanes>(rows, at + 0), load_every_fourth<lanes>(rows, at + 1),
          load_every_fourth<lanes>(rows, at + 2), load_every_fourth<lanes>(rows, at + 3)};
}

HWY_INLINE void store_rows(const Four& v, float* rows, const std::uint32_t* at) {
  store_every_fourth<lanes>(v.a, rows, at + 0);
  store_every_fourth<lanes>(v.b, rows, at + 1);
  store_every_fourth<lanes>(v.c, rows, at + 2);
  store_every_fourth<lanes>(v.d, rows, at + 3);
}

HWY_INLINE Four operator+(const Four& x, const Four& y) {
  return {hn::Add(x.a, y.a), hn::Add(x.b, y.b), hn::Add(x.c, y.c), hn::Add(x.d, y.d)};
}
HWY_INLINE Four operator-(const Four& x, const Four& y) {
  return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b), hn::Sub(x.c, y.c), hn::Sub(x.d, y.d)};
}

struct Triple {
  V x, y, z;
};

HWY_INLINE Triple operator+(const Triple& p, const Triple& q) {
  return {hn::Add(p.x, q.x), hn::Add(p.y, q.y), hn::Add(p.z, q.z)};
}
HWY_INLINE Triple operator-(const Triple& p, const Triple& q) {
  return {hn::Sub(p.x, q.x), hn::Sub(p.y, q.y), hn::Sub(p.z, q.z)};
}
HWY_INLINE Triple operator*(const Triple& p, V s) { return {hn::Mul(p.x, s), hn::Mul(p.y, s), hn::Mul(p.z, s)}; }
HWY_INLINE V dot(const Triple& p, const Triple& q) {
  return hn::Add(hn::Add(hn::Mul(p.x, q.x), hn::Mul(p.y, q.y)), hn::Mul(p.z, q.z));
}
HWY_INLINE Triple cross(const Triple& p, const Triple& q) {
  return {hn::Sub(hn::Mul(p.y, q.z), hn::Mul(p.z, q.y)), hn::Sub(hn::Mul(p.z, q.x), hn::Mul(p.x, q.z)),
          hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x))};
}

HWY_INLINE Triple as_coordinates(const Four& rows) {
  const Four m = transpose(rows);
  return {m.a, m.b, m.c};
}
HWY_INLINE Four as_rows(const Triple& coordinates) {
  return transpose({coordinates.x, coordinates.y, coordinates.z, hn::Zero(Floats())});
}

HWY_INLINE Four operator*(const Four& x, const Four& y) {
  return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b), hn::Mul(x.c, y.c), hn::Mul(x.d, y.d)};
}

/// Repeats the number of each entry in all of its four floats.
HWY_INLINE Four for_rows(V numbers) {
  return {hn::Broadcast<0>(numbers), hn::Broadcast<1>(numbers), hn::Broadcast<2>(numbers), hn::Broadcast<3>(numbers)};
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
