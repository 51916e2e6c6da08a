#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solvers/bounded/kernels/kernels_vector.cpp"
// Vectors whose length is known only at run time cannot take rows apart as is done here.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "sim/solvers/bounded/kernels/kernel_tables.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using FourFloats = hn::FixedTag<float, 4>;
using Floats = hn::CappedTag<float, block_size>;
using V = hn::Vec<Floats>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());

/// Four vectors of rows as they are loaded, or of one coordinate each.
struct Four {
  V a, b, c, d;
};

/// From rows to coordinates and back: within every 128 bits a 4x4 matrix is transposed.
HWY_INLINE Four transposed(const Four& m) {
  const Floats f;
  const V ac_low = hn::InterleaveLower(f, m.a, m.c);
  const V bd_low = hn::InterleaveLower(f, m.b, m.d);
  const V ac_high = hn::InterleaveUpper(f, m.a, m.c);
  const V bd_high = hn::InterleaveUpper(f, m.b, m.d);
  return {hn::InterleaveLower(f, ac_low, bd_low), hn::InterleaveUpper(f, ac_low, bd_low),
          hn::InterleaveLower(f, ac_high, bd_high), hn::InterleaveUpper(f, ac_high, bd_high)};
}

/// The rows that begin at [0], [4], ..., counted in floats, side by side.
template <std::size_t count>
HWY_INLINE auto load_every_fourth(const float* rows, const std::uint32_t* at) {
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
HWY_INLINE Triple operator*(const Triple& p, V s) {
  return {hn::Mul(p.x, s), hn::Mul(p.y, s), hn::Mul(p.z, s)};
}
HWY_INLINE V dot(const Triple& p, const Triple& q) {
  return hn::Add(hn::Add(hn::Mul(p.x, q.x), hn::Mul(p.y, q.y)), hn::Mul(p.z, q.z));
}
HWY_INLINE Triple cross(const Triple& p, const Triple& q) {
  return {hn::Sub(hn::Mul(p.y, q.z), hn::Mul(p.z, q.y)), hn::Sub(hn::Mul(p.z, q.x), hn::Mul(p.x, q.z)),
          hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x))};
}

HWY_INLINE Triple as_coordinates(const Four& rows) {
  const Four m = transposed(rows);
  return {m.a, m.b, m.c};
}
HWY_INLINE Four as_rows(const Triple& coordinates) {
  return transposed({coordinates.x, coordinates.y, coordinates.z, hn::Zero(Floats())});
}

HWY_INLINE Four operator*(const Four& x, const Four& y) {
  return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b), hn::Mul(x.c, y.c), hn::Mul(x.d, y.d)};
}

/// One number for each row, in the places of its coordinates.
HWY_INLINE Four for_rows(V numbers) {
  return {hn::Broadcast<0>(numbers), hn::Broadcast<1>(numbers), hn::Broadcast<2>(numbers),
          hn::Broadcast<3>(numbers)};
}

/// L' of `lanes` springs from lane k of a block, between rows that are loaded already.
HWY_INLINE Triple springs_between(const SpringBlock& block, std::size_t k, const Four& i, const Four& j) {
  const Floats f;
  const Triple start = {hn::Load(f, &block.start_x[k]), hn::Load(f, &block.start_y[k]),
                        hn::Load(f, &block.start_z[k])};
  return as_coordinates(i - j) + start;
}

HWY_INLINE void shorten_springs(const SpringBlock& block, std::size_t k, const Four& i, const Four& j,
                                const Triple& spring, V fraction, V share_i, float* rows) {
  const Four whole = as_rows(spring * fraction);
  const Four part_i = whole * for_rows(share_i);
  store_rows(i - part_i, rows, &block.at_i[k]);
  store_rows(j + (whole - part_i), rows, &block.at_j[k]);
}

/// In each of the rows' four places the sum of its coordinates, the fourth of which must be 0, as
/// (x + y) + z.
HWY_INLINE V sums_of_coordinates(V rows) {
  const V pairs = hn::Add(rows, hn::Shuffle2301(rows));
  return hn::Add(pairs, hn::Shuffle1032(pairs));
}

/// Of a vector of rows, those further away than their tethers reach are brought back.
HWY_INLINE V held(V rows, const Tether* tethers, V pins_moved, V is_coordinate) {
  const Floats f;
  const V tether = hn::Load(f, &tethers->start_x);
  const V from_pin = hn::And(hn::Add(hn::Sub(rows, pins_moved), tether), is_coordinate);
  const V squared = sums_of_coordinates(hn::Mul(from_pin, from_pin));
  const V limit = hn::Broadcast<3>(tether);
  const V excess = hn::Sub(squared, limit);
  const auto too_far = hn::Gt(excess, hn::Zero(f));
  if (hn::AllFalse(f, too_far)) {
    return rows;
  }
  const V error = hn::IfThenElseZero(too_far, hn::Div(excess, hn::Add(squared, limit)));
  return hn::Sub(rows, hn::Mul(from_pin, error));
}

void predict(std::size_t begin, std::size_t end, const Prediction& prediction, const Tether* tethers,
             const Row* accelerations, const Row* current, Row* previous) {
  const Floats f;
  const V decays = hn::Set(f, prediction.decay);
  const V dts_squared = hn::Set(f, prediction.dt_squared);
  const V pins_moved = hn::LoadDup128(f, &prediction.pins_moved.x);
  alignas(16) static constexpr std::uint32_t coordinates[4] = {~0U, ~0U, ~0U, 0U};
  const V is_coordinate = hn::BitCast(f, hn::LoadDup128(hn::RebindToUnsigned<Floats>(), coordinates));
  for (std::size_t r = begin; r < end; r += lanes / 4) {
    const V d = hn::Load(f, &current[r].x);
    const V moved = hn::Mul(hn::Sub(d, hn::Load(f, &previous[r].x)), decays);
    const V driven = hn::Mul(hn::Load(f, &accelerations[r].x), dts_squared);
    const V predicted = hn::Add(d, hn::Add(moved, driven));
    hn::Store(tethers == nullptr ? predicted : held(predicted, tethers + r, pins_moved, is_coordinate), f,
              &previous[r].x);
  }
}

void start_springs(const StartRows& start, std::size_t begin, std::size_t end, SpringLanes& springs) {
  const Floats f;
  const float* high = &start.high[0].x;
  const float* low = &start.low[0].x;
  for (std::size_t b = begin; b < end; ++b) {
    SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four coarse = load_rows(high, &block.at_i[k]) - load_rows(high, &block.at_j[k]);
      const Four fine = load_rows(low, &block.at_i[k]) - load_rows(low, &block.at_j[k]);
      const Triple spring = as_coordinates(coarse + fine);
      hn::Store(spring.x, f, &block.start_x[k]);
      hn::Store(spring.y, f, &block.start_y[k]);
      hn::Store(spring.z, f, &block.start_z[k]);
    }
  }
}

void sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Row* rows) {
  const Floats f;
  float* first = &rows->x;
  const SpringBlock* const last = springs.blocks.data() + end;
  for (const SpringBlock* block = springs.blocks.data() + begin; block != last; ++block) {
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four i = load_rows(first, &block->at_i[k]);
      const Four j = load_rows(first, &block->at_j[k]);
      const Triple spring = springs_between(*block, k, i, j);
      const V squared_length = dot(spring, spring);
      const V squared_rest = hn::Load(f, &block->squared_rest[k]);
      const V error = hn::Div(hn::Sub(squared_length, squared_rest), hn::Add(squared_length, squared_rest));
      // A share is at most 1, so the larger of the two is the error of springs too long, a share of it else.
      const V fraction = hn::Max(error, hn::Mul(error, hn::Load(f, &block->short_share[k])));
      shorten_springs(*block, k, i, j, spring, fraction, hn::Load(f, &block->share_i[k]), first);
    }
  }
}

/// Where rows k, k + 1, ... begin, counted in floats.
HWY_INLINE std::array<std::uint32_t, lanes> rows_from(std::size_t k) {
  std::array<std::uint32_t, lanes> at;
  for (std::uint32_t lane = 0; lane < lanes; ++lane) {
    at[lane] = 4 * (static_cast<std::uint32_t>(k) + lane);
  }
  return at;
}

void shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
             float relaxation, Row* rows) {
  const Floats f;
  float* first = &rows->x;
  for (const std::uint32_t b : blocks) {
    const SpringBlock& block = springs.blocks[b];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four i = load_rows(first, &block.at_i[k]);
      const Four j = load_rows(first, &block.at_j[k]);
      const Triple spring = springs_between(block, k, i, j);
      const V squared_length = dot(spring, spring);
      const V limit = hn::Mul(hn::Load(f, &block.squared_rest[k]), hn::Set(f, squared_bound));
      const V excess = hn::Sub(squared_length, limit);
      const auto too_long = hn::Gt(excess, hn::Zero(f));
      if (hn::AllFalse(f, too_long)) {
        continue;
      }
      const V divisor = hn::Add(squared_length, hn::Sqrt(hn::Mul(squared_length, limit)));
      const V fraction = hn::Mul(hn::Div(excess, divisor), hn::Set(f, relaxation));
      shorten_springs(block, k, i, j, spring, hn::IfThenElseZero(too_long, fraction),
                      hn::Load(f, &springs.certificate_share_i[b * block_size + k]), first);
    }
  }
}

void largest_ratios(const SpringLanes& springs, std::size_t begin, std::size_t end, const Row* rows,
                    float* squared_ratios) {
  const Floats f;
  const float* first = &rows->x;
  for (std::size_t b = begin; b < end; ++b) {
    const SpringBlock& block = springs.blocks[b];
    V largest = hn::Zero(f);
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four i = load_rows(first, &block.at_i[k]);
      const Four j = load_rows(first, &block.at_j[k]);
      const Triple spring = springs_between(block, k, i, j);
      largest = hn::Max(largest, hn::Div(dot(spring, spring), hn::Load(f, &block.squared_rest[k])));
    }
    squared_ratios[b] = hn::GetLane(hn::MaxOfLanes(f, largest));
  }
}

struct LoadedCorner {
  Triple position;
  Triple moved;
};

HWY_INLINE LoadedCorner load_corner(const TriangleLanes& triangles, std::size_t corner, std::size_t k,
                                    const Row* start, const Row* current, const Row* previous) {
  const std::uint32_t* at = &triangles.at[corner][k];
  const Four now = load_rows(&current->x, at);
  return {as_coordinates(load_rows(&start->x, at) + now), as_coordinates(now - load_rows(&previous->x, at))};
}

/// Half the air's density times a coefficient times a speed, as the drag over one held interval.
HWY_INLINE V held_drag(V drag, V held) {
  return hn::Div(drag, hn::Add(hn::Set(Floats(), 1.0F), hn::Mul(held, drag)));
}

HWY_INLINE Triple corner_force(const AirFlow& air, const LoadedCorner& a, const LoadedCorner& b,
                               const LoadedCorner& c) {
  const Floats f;
  const Triple moved = (a.moved + b.moved) + c.moved;
  const Triple flow = {hn::Set(f, air.velocity_m_per_s[0]), hn::Set(f, air.velocity_m_per_s[1]),
                       hn::Set(f, air.velocity_m_per_s[2])};
  const Triple u = flow - moved * hn::Set(f, air.per_time_step / 3.0F);

  const Triple doubled_area = cross(b.position - a.position, c.position - a.position);
  const V doubled_size = hn::Sqrt(dot(doubled_area, doubled_area));
  const V divisor = hn::Max(doubled_size, hn::Set(f, smallest_doubled_area_m2));
  const Triple normal = doubled_area * hn::Div(hn::Set(f, 1.0F), divisor);
  const V u_n = dot(u, normal);
  const Triple along_normal = normal * u_n;
  const V pressure = hn::Mul(hn::Set(f, air.half_density_pressure), hn::Abs(u_n));
  const V friction = hn::Mul(hn::Set(f, air.half_density_friction), hn::Sqrt(dot(u, u)));
  const V held = hn::Set(f, air.time_per_density * 2.0F);
  const Triple per_area =
      along_normal * held_drag(pressure, held) + (u - along_normal) * held_drag(friction, held);
  return per_area * hn::Div(doubled_size, hn::Set(f, 6.0F));
}

void wind(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
          const Row* start, const Row* current, const Row* previous, Row* corner_forces) {
  for (std::size_t k = begin; k < end; k += lanes) {
    const Triple force = corner_force(air, load_corner(triangles, 0, k, start, current, previous),
                                      load_corner(triangles, 1, k, start, current, previous),
                                      load_corner(triangles, 2, k, start, current, previous));
    store_rows(as_rows(force), &corner_forces->x, rows_from(k).data());
  }
}

void add_product(const SlicedMatrix& matrix, std::size_t begin, std::size_t end, const Row* positions,
                 Row* result) {
  const Floats f;
  const float* first = &positions->x;
  for (std::size_t lane = begin * block_size; lane < end * block_size; lane += lanes) {
    const std::size_t slice = lane / block_size;
    const std::uint32_t* row_at = &matrix.row_at[lane];
    const Triple x = as_coordinates(load_rows(first, row_at));
    Triple sum = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
    const std::size_t last = matrix.begin[slice + 1] * block_size;
    for (std::size_t e = matrix.begin[slice] * block_size + lane % block_size; e < last; e += block_size) {
      const Triple to_column = as_coordinates(load_rows(first, &matrix.column_at[e])) - x;
      sum = sum + to_column * hn::Load(f, &matrix.value[e]);
    }
    store_rows(load_rows(&result->x, row_at) + as_rows(sum), &result->x, row_at);
  }
}

const Kernels& kernel_table() {
  static constexpr Kernels table = {predict,        start_springs, sweep,      shorten,
                                    largest_ratios, wind,          add_product};
  return table;
}

#endif

}  // namespace

const Kernels* table() {
#if HWY_TARGET == HWY_SCALAR
  return nullptr;
#else
  return &kernel_table();
#endif
}

}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut::sim::bounded {
namespace {

HWY_EXPORT(table);

bool supported(std::int64_t target) {
  return (hwy::SupportedTargets() & target) != 0;
}

}  // namespace

const Kernels* vector_kernels(VectorUnit unit) {
  switch (unit) {
    case VectorUnit::best:
      return HWY_DYNAMIC_DISPATCH(table)();
    case VectorUnit::avx512:
#if HWY_TARGETS & HWY_AVX3
      return supported(HWY_AVX3) ? N_AVX3::table() : nullptr;
#else
      return nullptr;
#endif
    case VectorUnit::avx2:
#if HWY_TARGETS & HWY_AVX2
      return supported(HWY_AVX2) ? N_AVX2::table() : nullptr;
#else
      return nullptr;
#endif
    case VectorUnit::sse:
#if HWY_TARGETS & HWY_SSE4
      return supported(HWY_SSE4) ? N_SSE4::table() : nullptr;
#else
      return nullptr;
#endif
    case VectorUnit::scalar:
      break;
  }
  return nullptr;
}

}  // namespace taut::sim::bounded

#endif
