#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solvers/bounded/kernels/kernels_vector.cpp"
// Vectors with a length known only at run time cannot be split into entries.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "sim/solvers/bounded/kernels/boxes_inl.hpp"
#include "sim/solvers/bounded/kernels/kernel_tables.hpp"
#include "sim/solvers/bounded/kernels/near_inl.hpp"
#include "sim/solvers/bounded/kernels/planes_inl.hpp"
#include "sim/solvers/bounded/kernels/surface_inl.hpp"
#include "sim/solvers/bounded/kernels/vectors_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

/// Returns L' of `lanes` springs from lane k of a block, with ends that are loaded already.
HWY_INLINE Triple springs_between(const SpringBlock& block, std::size_t k, const Four& i, const Four& j) {
  const Floats f;
  const Triple start = {hn::Load(f, &block.start_x[k]), hn::Load(f, &block.start_y[k]), hn::Load(f, &block.start_z[k])};
  return as_coordinates(i - j) + start;
}

HWY_INLINE void shorten_springs(const SpringBlock& block, std::size_t k, const Four& i, const Four& j,
                                const Triple& spring, V fraction, V share_i, float* rows) {
  const Four whole = as_rows(spring * fraction);
  const Four part_i = whole * for_rows(share_i);
  store_rows(i - part_i, rows, &block.at_i[k]);
  store_rows(j + (whole - part_i), rows, &block.at_j[k]);
}

/// Returns, in all four floats of each entry, its sum of coordinates (x + y) + z. The fourth float must be 0.
HWY_INLINE V sums_of_coordinates(V rows) {
  const V pairs = hn::Add(rows, hn::Shuffle2301(rows));
  return hn::Add(pairs, hn::Shuffle1032(pairs));
}

/// Sets the fourth float of each entry to 0.
HWY_INLINE V coordinates_alone(V rows) {
  alignas(16) static constexpr std::uint32_t coordinates[4] = {~0U, ~0U, ~0U, 0U};
  return hn::And(rows, hn::BitCast(Floats(), hn::LoadDup128(hn::RebindToUnsigned<Floats>(), coordinates)));
}

/// Moves vertices beyond the length of their tether back to that length.
HWY_INLINE V apply_tethers(V rows, const Tether* tethers, V pins_moved) {
  const Floats f;
  const V tether = hn::Load(f, &tethers->start_x);
  const V from_pin = coordinates_alone(hn::Add(hn::Sub(rows, pins_moved), tether));
  const V squared = sums_of_coordinates(hn::Mul(from_pin, from_pin));
  const V limit = hn::Broadcast<3>(tether);
  const V excess = hn::Sub(squared, limit);
  const auto too_far = hn::Gt(excess, hn::Zero(f));
  if (hn::AllFalse(f, too_far)) return rows;
  const V error = hn::IfThenElseZero(too_far, hn::Div(excess, hn::Add(squared, limit)));
  return hn::Sub(rows, hn::Mul(from_pin, error));
}

void predict(std::size_t begin, std::size_t end, const Prediction& prediction, const Tether* tethers,
             const Float4* accelerations, const Float4* current, Float4* previous) {
  const Floats f;
  const V decays = hn::Set(f, prediction.decay);
  const V dts_squared = hn::Set(f, prediction.dt_squared);
  const V pins_moved = hn::LoadDup128(f, &prediction.pins_moved.x);
  for (std::size_t r = begin; r < end; r += lanes / 4) {
    const V d = hn::Load(f, as_floats(current + r));
    const V moved = hn::Mul(hn::Sub(d, hn::Load(f, as_floats(previous + r))), decays);
    const V driven = hn::Mul(hn::Load(f, as_floats(accelerations + r)), dts_squared);
    const V predicted = hn::Add(d, hn::Add(moved, driven));
    hn::Store(tethers == nullptr ? predicted : apply_tethers(predicted, tethers + r, pins_moved), f,
              as_floats(previous + r));
  }
}

void start_springs(const StartRows& start, std::size_t begin, std::size_t end, SpringLanes& springs) {
  const Floats f;
  const float* high = as_floats(start.high.data());
  const float* low = as_floats(start.low.data());
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

void sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Float4* rows) {
  const Floats f;
  float* first = as_floats(rows);
  const SpringBlock* const last = springs.blocks.data() + end;
  for (const SpringBlock* block = springs.blocks.data() + begin; block != last; ++block) {
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four i = load_rows(first, &block->at_i[k]);
      const Four j = load_rows(first, &block->at_j[k]);
      const Triple spring = springs_between(*block, k, i, j);
      const V squared_length = dot(spring, spring);
      const V squared_rest = hn::Load(f, &block->squared_rest[k]);
      const V error = hn::Div(hn::Sub(squared_length, squared_rest), hn::Add(squared_length, squared_rest));
      // The fraction is at most 1. So the larger value is the whole error if the spring is too long, and a fraction of
      // it otherwise.
      const V fraction = hn::Max(error, hn::Mul(error, hn::Load(f, &block->short_share[k])));
      shorten_springs(*block, k, i, j, spring, fraction, hn::Load(f, &block->share_i[k]), first);
    }
  }
}

/// Returns the offsets of the entries k, k + 1, ... in floats.
HWY_INLINE std::array<std::uint32_t, lanes> rows_from(std::size_t k) {
  std::array<std::uint32_t, lanes> at;
  for (std::uint32_t lane = 0; lane < lanes; ++lane) at[lane] = 4 * (static_cast<std::uint32_t>(k) + lane);
  return at;
}

void shorten_blocks(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
                    float relaxation, Float4* rows) {
  const Floats f;
  float* first = as_floats(rows);
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
      if (hn::AllFalse(f, too_long)) continue;
      const V divisor = hn::Add(squared_length, hn::Sqrt(hn::Mul(squared_length, limit)));
      const V fraction = hn::Mul(hn::Div(excess, divisor), hn::Set(f, relaxation));
      shorten_springs(block, k, i, j, spring, hn::IfThenElseZero(too_long, fraction),
                      hn::Load(f, &springs.projection_share_i[b * block_size + k]), first);
    }
  }
}

void find_max_ratios(const SpringLanes& springs, std::size_t begin, std::size_t end, const Float4* rows,
                     float* squared_ratios) {
  const Floats f;
  const float* first = as_floats(rows);
  for (std::size_t b = begin; b < end; ++b) {
    const SpringBlock& block = springs.blocks[b];
    V max_ratio = hn::Zero(f);
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Four i = load_rows(first, &block.at_i[k]);
      const Four j = load_rows(first, &block.at_j[k]);
      const Triple spring = springs_between(block, k, i, j);
      max_ratio = hn::Max(max_ratio, hn::Div(dot(spring, spring), hn::Load(f, &block.squared_rest[k])));
    }
    squared_ratios[b] = hn::GetLane(hn::MaxOfLanes(f, max_ratio));
  }
}

struct LoadedCorner {
  Triple position;
  Triple moved;
  Four opposed;
};

HWY_INLINE LoadedCorner load_corner(const TriangleLanes& triangles, std::size_t corner, std::size_t k,
                                    const Float4* start, const Float4* current, const Float4* previous,
                                    const Float4* constraint_velocity) {
  const std::uint32_t* at = &triangles.at[corner][k];
  const Four now = load_rows(as_floats(current), at);
  return {as_coordinates(load_rows(as_floats(start), at) + now),
          as_coordinates(now - load_rows(as_floats(previous), at)), load_rows(as_floats(constraint_velocity), at)};
}

/// Returns a force per area at the end of one linearised implicit step. `slope` is its derivative by a speed.
HWY_INLINE V force_after(V force, V slope, V time_per_density) {
  return hn::Div(force, hn::Add(hn::Set(Floats(), 1.0F), hn::Mul(time_per_density, slope)));
}

/// Normal force of the air per area, at least 0, and its derivative by the normal speed.
struct NormalForce {
  V force;
  V slope;
};

/// Returns the law of add_wind_forces.
HWY_INLINE NormalForce normal_force(V half_density_pressure, V speed, V normal_speed) {
  const Floats f;
  constexpr float pi = 3.14159265F;
  const V four = hn::Set(f, 4.0F);
  const V sine = hn::Div(normal_speed, hn::Max(speed, hn::Set(f, min_air_speed_m_per_s)));
  const V per_divisor = hn::Div(hn::Set(f, 1.0F), hn::Add(four, hn::Mul(hn::Set(f, pi), sine)));
  const V drag = hn::Mul(hn::Mul(half_density_pressure, hn::Set(f, 4.0F + pi)), hn::Mul(speed, per_divisor));
  const V rise = hn::Mul(hn::Mul(sine, sine), hn::Add(four, hn::Mul(hn::Set(f, 2.0F * pi), sine)));
  return {hn::Mul(drag, normal_speed), hn::Mul(drag, hn::Mul(hn::Add(four, rise), per_divisor))};
}

/// Returns the speed at which other forces move a triangle against the normal air flow, in m/s; at least 0.
HWY_INLINE V opposing_speed(const Four& constraint_velocity, const Triple& normal, V u_n) {
  const Floats f;
  const Four sum = transpose(constraint_velocity);
  const V along = hn::Div(dot({sum.a, sum.b, sum.c}, normal), hn::Max(sum.d, hn::Set(f, 1.0F)));
  return hn::Max(hn::IfThenElse(hn::Lt(u_n, hn::Zero(f)), along, hn::Neg(along)), hn::Zero(f));
}

/// `fraction` is that of the air's velocity.
HWY_INLINE Triple corner_force(const AirFlow& air, V fraction, const LoadedCorner& a, const LoadedCorner& b,
                               const LoadedCorner& c) {
  const Floats f;
  const Triple moved = (a.moved + b.moved) + c.moved;
  const Triple flow = {hn::Set(f, air.velocity_m_per_s[0]), hn::Set(f, air.velocity_m_per_s[1]),
                       hn::Set(f, air.velocity_m_per_s[2])};
  const Triple u = flow * fraction - moved * hn::Set(f, air.per_time_step / 3.0F);

  const Triple doubled_area = cross(b.position - a.position, c.position - a.position);
  const V doubled_size = hn::Sqrt(dot(doubled_area, doubled_area));
  const V divisor = hn::Max(doubled_size, hn::Set(f, min_doubled_area_m2));
  const Triple normal = doubled_area * hn::Div(hn::Set(f, 1.0F), divisor);
  const V u_n = dot(u, normal);
  const V speed = hn::Sqrt(dot(u, u));
  const V time_per_density = hn::Set(f, air.time_per_density);
  const NormalForce pressure = normal_force(hn::Set(f, air.half_density_pressure), speed, hn::Abs(u_n));
  const V constraint_velocity = opposing_speed(a.opposed + b.opposed + c.opposed, normal, u_n);
  const V max_opposing = hn::Mul(time_per_density, pressure.force);
  const V kept_up = hn::Mul(pressure.slope, hn::Min(constraint_velocity, max_opposing));
  const V normal_pressure = force_after(hn::Add(pressure.force, kept_up), pressure.slope, time_per_density);
  const V friction = hn::Mul(hn::Set(f, air.half_density_friction), speed);
  const Triple per_area = normal * hn::CopySign(normal_pressure, u_n) +
                          (u - normal * u_n) * force_after(friction, hn::Add(friction, friction), time_per_density);
  return per_area * hn::Div(doubled_size, hn::Set(f, 6.0F));
}

void wind(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end, const Float4* start,
          const Float4* current, const Float4* previous, const Float4* constraint_velocity, Float4* corner_forces) {
  for (std::size_t k = begin; k < end; k += lanes) {
    const Triple force = corner_force(air, hn::Load(Floats(), air.fractions + k),
                                      load_corner(triangles, 0, k, start, current, previous, constraint_velocity),
                                      load_corner(triangles, 1, k, start, current, previous, constraint_velocity),
                                      load_corner(triangles, 2, k, start, current, previous, constraint_velocity));
    store_rows(as_rows(force), as_floats(corner_forces), rows_from(k).data());
  }
}

/// Prefetch distance in entries of a slice.
constexpr std::size_t entries_ahead = 24;

void add_product(const SlicedMatrix& matrix, std::size_t begin, std::size_t end, const Float4* positions,
                 Float4* result) {
  const Floats f;
  const float* first = as_floats(positions);
  for (std::size_t lane = begin * block_size; lane < end * block_size; lane += lanes) {
    const std::size_t slice = lane / block_size;
    const std::uint32_t* row_at = &matrix.row_at[lane];
    const Triple x = as_coordinates(load_rows(first, row_at));
    Triple sum = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
    const std::size_t last = matrix.begin[slice + 1] * block_size;
    for (std::size_t e = matrix.begin[slice] * block_size + lane % block_size; e < last; e += block_size) {
      const std::size_t ahead = std::min(e + entries_ahead * block_size, matrix.value.size() - 1);
      fetch(matrix.column_at[ahead]);
      fetch(matrix.value[ahead]);
      const Triple to_column = as_coordinates(load_rows(first, &matrix.column_at[e])) - x;
      sum = sum + to_column * hn::Load(f, &matrix.value[e]);
    }
    store_rows(load_rows(as_floats(result), row_at) + as_rows(sum), as_floats(result), row_at);
  }
}

std::size_t list_off_motion(const Float4* since, const Float4* moves, float time, std::size_t begin, std::size_t end,
                            const Float4* displacements, std::uint32_t* rows) {
  const Floats f;
  const V times = hn::Set(f, time);
  std::size_t size = 0;
  for (std::size_t r = begin * block_size; r < end * block_size; r += lanes / 4) {
    const V moved = hn::Sub(hn::Load(f, as_floats(displacements + r)), hn::Load(f, as_floats(since + r)));
    const V way = hn::Load(f, as_floats(moves + r));
    const V off = coordinates_alone(hn::Sub(moved, hn::Mul(way, times)));
    const V free = hn::Broadcast<3>(way);
    const Mask is_off = hn::Not(hn::Le(sums_of_coordinates(hn::Mul(off, off)), hn::Mul(free, free)));
    for (std::size_t k = 0; k < lanes / 4 && !hn::AllFalse(f, is_off); ++k) {
      rows[size] = static_cast<std::uint32_t>(r + k);
      size += mask_bits(is_off) >> (4 * k) & 1U;
    }
  }
  return size;
}

const Kernels* table() {
  static constexpr ContactKernels contact = {
      enclose,         enclose_blocks,  round_boxes,          overlapping,          keep_near<1>,   keep_near<2>,
      place_planes<1>, place_planes<2>, measure_distances<1>, measure_distances<2>, list_off_motion};
  static constexpr Kernels kernels = {
      predict,         start_springs,           sweep, shorten_blocks, find_max_ratios, start_surface, sweep_surface,
      shorten_surface, find_max_surface_ratios, wind,  add_product,    contact};
  return &kernels;
}

#else

const Kernels* table() { return nullptr; }

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut::sim::bounded {

#ifdef HWY_COMPILE_ONLY_EMU128

const Kernels& emulated_kernels() { return *N_EMU128::table(); }

#else

namespace {

HWY_EXPORT(table);

[[maybe_unused]] bool supported(std::int64_t target) { return (hwy::SupportedTargets() & target) != 0; }

}  // namespace

const Kernels* vector_kernels(VectorUnit unit) {
#if HWY_TARGETS & HWY_AVX3
  if (unit == VectorUnit::avx512 && supported(HWY_AVX3)) return N_AVX3::table();
#endif
#if HWY_TARGETS & HWY_AVX2
  if (unit == VectorUnit::avx2 && supported(HWY_AVX2)) return N_AVX2::table();
#endif
#if HWY_TARGETS & HWY_SSE4
  if (unit == VectorUnit::sse && supported(HWY_SSE4)) return N_SSE4::table();
#endif
  return unit == VectorUnit::best ? HWY_DYNAMIC_DISPATCH(table)() : nullptr;
}

#endif

}  // namespace taut::sim::bounded

#endif
