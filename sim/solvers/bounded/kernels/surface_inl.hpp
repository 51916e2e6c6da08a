// Kernels that bound the stretch of triangles, for the target being compiled. The file is included once per target, so
// its include guard is of another kind.
#if defined(TAUT_SURFACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_SURFACE_INL
#undef TAUT_SURFACE_INL
#else
#define TAUT_SURFACE_INL
#endif

#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/vectors_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

/// Corners of `lanes` triangles, by vertex.
struct CornerRows {
  Four a, b, c;
};

/// Columns of a deformation gradient F.
struct Gradient {
  Triple along, across;
};

HWY_INLINE CornerRows load_corners(const SurfaceBlock& block, std::size_t k, const float* rows) {
  return {load_rows(rows, &block.at[0][k]), load_rows(rows, &block.at[1][k]), load_rows(rows, &block.at[2][k])};
}

HWY_INLINE Triple load_triple(const std::array<SurfaceBlock::Of<float>, 3>& values, std::size_t k) {
  const Floats f;
  return {hn::Load(f, &values[0][k]), hn::Load(f, &values[1][k]), hn::Load(f, &values[2][k])};
}

HWY_INLINE void store_triple(const Triple& v, std::size_t k, std::array<SurfaceBlock::Of<float>, 3>& values) {
  const Floats f;
  hn::Store(v.x, f, &values[0][k]);
  hn::Store(v.y, f, &values[1][k]);
  hn::Store(v.z, f, &values[2][k]);
}

/// Returns F of the edges e1 and e2, or the change of F if these are displacements.
HWY_INLINE Gradient gradient_from_edges(const SurfaceBlock& block, std::size_t k, const Triple& e1, const Triple& e2) {
  const Floats f;
  return {e1 * hn::Load(f, &block.along_per_m[k]),
          e2 * hn::Load(f, &block.across_per_m[k]) - e1 * hn::Load(f, &block.skew_per_m[k])};
}

HWY_INLINE Gradient gradient_now(const SurfaceBlock& block, std::size_t k, const CornerRows& corners) {
  const Gradient moved =
      gradient_from_edges(block, k, as_coordinates(corners.b - corners.a), as_coordinates(corners.c - corners.a));
  return {moved.along + load_triple(block.start_along, k), moved.across + load_triple(block.start_across, k)};
}

/// The squared singular values of F are mean + radius and mean - radius. The cosine and sine of twice the angle of the
/// direction of the largest are difference / radius and product / radius.
struct Principal {
  V mean, radius;
  V difference, product;

  HWY_INLINE V max_squared() const { return hn::Add(mean, radius); }
  HWY_INLINE V min_squared() const { return hn::Sub(mean, radius); }
};

HWY_INLINE Principal find_principal(const Gradient& gradient) {
  const Floats f;
  const V half = hn::Set(f, 0.5F);
  const V a = dot(gradient.along, gradient.along);
  const V b = dot(gradient.along, gradient.across);
  const V c = dot(gradient.across, gradient.across);
  const V difference = hn::Mul(hn::Sub(a, c), half);
  const V radius = hn::Sqrt(hn::Add(hn::Mul(difference, difference), hn::Mul(b, b)));
  return {hn::Mul(hn::Add(a, c), half), hn::Max(radius, hn::Set(f, min_radius)), difference, b};
}

struct Mobility {
  V a, b, c;
  V along_less_across, skew;
};

HWY_INLINE Mobility load_mobility(const SurfaceMobility& mobility, std::size_t k) {
  const Floats f;
  return {hn::Load(f, &mobility.corners[0][k]), hn::Load(f, &mobility.corners[1][k]),
          hn::Load(f, &mobility.corners[2][k]), hn::Load(f, &mobility.along_less_across[k]),
          hn::Load(f, &mobility.skew[k])};
}

/// Sums of w (g v)^2 in both principal directions, times the radius.
struct Divisors {
  V first, second;
};

HWY_INLINE Divisors find_divisors(const Mobility& mobility, const Principal& p) {
  const V middle = hn::Mul(p.radius, hn::Set(Floats(), 0.5F + min_mobility));
  const V to_first = hn::Add(hn::Mul(mobility.along_less_across, p.difference), hn::Mul(mobility.skew, p.product));
  return {hn::Add(middle, to_first), hn::Sub(middle, to_first)};
}

/// Triangles of the lanes k, k + 1, ... of a block.
struct TriangleGroup {
  const SurfaceBlock* block;
  const SurfaceMobility* mobility;
  std::size_t k;
};

/// Loaded triangles, and their errors in both directions over the divisors.
struct FoundErrors {
  CornerRows corners;
  Gradient gradient;
  Principal principal;
  Mobility mobility;
  V first, second;
};

HWY_INLINE void load_triangles(const TriangleGroup& at, const float* rows, FoundErrors& found) {
  found.corners = load_corners(*at.block, at.k, rows);
  found.gradient = gradient_now(*at.block, at.k, found.corners);
  found.principal = find_principal(found.gradient);
  found.mobility = load_mobility(*at.mobility, at.k);
}

/// Symmetric matrix with the eigenvalues `first` and `second` in the principal directions.
struct Symmetric {
  V along, across, mixed;
};

HWY_INLINE Symmetric symmetric(const Principal& p, V first, V second) {
  const V half = hn::Set(Floats(), 0.5F);
  const V mean = hn::Mul(hn::Mul(hn::Add(first, second), half), p.radius);
  const V half_difference = hn::Mul(hn::Sub(first, second), half);
  const V cosine = hn::Mul(half_difference, p.difference);
  return {hn::Add(mean, cosine), hn::Sub(mean, cosine), hn::Mul(half_difference, p.product)};
}

HWY_INLINE void move_corners(const TriangleGroup& at, const FoundErrors& found, float* rows) {
  const Floats f;
  const auto& [block, unused, k] = at;
  // The change of F is F times this matrix.
  const auto [s11, s22, s12] = symmetric(found.principal, found.first, found.second);
  const V along = hn::Load(f, &block->along_per_m[k]);
  const V across = hn::Load(f, &block->across_per_m[k]);
  const V skew = hn::Load(f, &block->skew_per_m[k]);
  const Triple b = found.gradient.along * hn::Sub(hn::Mul(along, s11), hn::Mul(skew, s12)) +
                   found.gradient.across * hn::Sub(hn::Mul(along, s12), hn::Mul(skew, s22));
  const Triple c = found.gradient.along * hn::Mul(across, s12) + found.gradient.across * hn::Mul(across, s22);
  store_rows(found.corners.a + as_rows((b + c) * found.mobility.a), rows, &block->at[0][k]);
  store_rows(found.corners.b - as_rows(b * found.mobility.b), rows, &block->at[1][k]);
  store_rows(found.corners.c - as_rows(c * found.mobility.c), rows, &block->at[2][k]);
}

constexpr std::size_t places_per_block = block_size / lanes;

/// Prefetch distance in blocks.
constexpr std::size_t blocks_ahead = 4;

/// Prefetches the block that is due at place i of `count`.
template <typename Work> HWY_INLINE void fetch_ahead(std::size_t i, std::size_t count, const Work& work) {
  const std::size_t ahead = i + blocks_ahead * places_per_block;
  if (i % places_per_block == 0 && ahead < count) work.fetch_block(ahead / places_per_block);
}

/// Corrects `count` places by `work`: place(i) is the i-th place, find(place, found) computes its correction, and
/// fetch_block(b) prefetches the b-th block. Two are processed at a time: one is computed while the other waits for a
/// square root or a division.
template <typename Work> HWY_INLINE void correct(std::size_t count, const Work& work, float* rows) {
  std::size_t i = 0;
  for (; i + 1 < count; i += 2) {
    fetch_ahead(i, count, work);
    fetch_ahead(i + 1, count, work);
    const TriangleGroup a = work.place(i);
    const TriangleGroup b = work.place(i + 1);
    FoundErrors found_a;
    FoundErrors found_b;
    const bool is_a_long = work.find(a, rows, found_a);
    const bool is_b_long = work.find(b, rows, found_b);
    if (is_a_long) {
      work.note(a, found_a);
      move_corners(a, found_a, rows);
    }
    if (is_b_long) {
      work.note(b, found_b);
      move_corners(b, found_b, rows);
    }
  }
  if (i < count) {
    const TriangleGroup a = work.place(i);
    FoundErrors found_a;
    if (work.find(a, rows, found_a)) {
      work.note(a, found_a);
      move_corners(a, found_a, rows);
    }
  }
}

void start_surface(const StartRows& start, std::size_t begin, std::size_t end, SurfaceLanes& triangles) {
  for (std::size_t b = begin; b < end; ++b) {
    SurfaceBlock& block = triangles.blocks[b];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const CornerRows high = load_corners(block, k, as_floats(start.high.data()));
      const CornerRows low = load_corners(block, k, as_floats(start.low.data()));
      const Triple e1 = as_coordinates((high.b - high.a) + (low.b - low.a));
      const Triple e2 = as_coordinates((high.c - high.a) + (low.c - low.a));
      const Gradient gradient = gradient_from_edges(block, k, e1, e2);
      store_triple(gradient.along, k, block.start_along);
      store_triple(gradient.across, k, block.start_across);
    }
  }
}

HWY_INLINE void add_to(V value, std::size_t k, std::array<float, block_size>& sums) {
  const Floats f;
  hn::Store(hn::Add(hn::Load(f, &sums[k]), value), f, &sums[k]);
}

template <bool sums_up> struct Sweep {
  const SurfaceBlock* blocks;
  SurfaceSums* sums;  ///< sums of the same blocks
  float relaxation;
  float short_part;  ///< factor on corrections of short triangles: 1, or 0 for none

  HWY_INLINE TriangleGroup place(std::size_t i) const {
    const SurfaceBlock* block = blocks + i / places_per_block;
    return {block, &block->mobility, i % places_per_block * lanes};
  }

  HWY_INLINE void fetch_block(std::size_t block) const { fetch(blocks[block]); }

  HWY_INLINE bool find(const TriangleGroup& at, const float* rows, FoundErrors& found) const {
    const Floats f;
    const V one = hn::Set(f, 1.0F);
    load_triangles(at, rows, found);
    const Principal& s = found.principal;
    const Divisors divisors = find_divisors(found.mobility, s);
    const V first_divisor = hn::Mul(hn::Add(s.max_squared(), one), divisors.first);
    const V second_divisor = hn::Mul(hn::Add(s.min_squared(), one), divisors.second);
    const V per_both = hn::Div(one, hn::Mul(first_divisor, second_divisor));
    const V first = hn::Mul(hn::Mul(hn::Sub(s.max_squared(), one), second_divisor), per_both);
    const V second = hn::Mul(hn::Mul(hn::Sub(s.min_squared(), one), first_divisor), per_both);
    // The fraction is at most 1, and relaxation at least 1. So the larger value is relaxation times the error if the
    // triangle is too long, and a fraction of the error otherwise.
    const V share = hn::Mul(hn::Load(f, &at.block->short_share[at.k]), hn::Set(f, short_part));
    const V whole = hn::Set(f, relaxation);
    found.first = hn::Max(hn::Mul(first, whole), hn::Mul(first, share));
    found.second = hn::Max(hn::Mul(second, whole), hn::Mul(second, share));
    return true;
  }

  // A force is tension times the length ratio s: (s^2 + 1) / 2 is s to first order.
  HWY_INLINE void note(const TriangleGroup& at, const FoundErrors& found) const {
    if constexpr (sums_up) {
      const Floats f;
      const V half = hn::Set(f, 0.5F);
      const Principal& p = found.principal;
      const V largest = hn::Add(hn::Mul(p.max_squared(), half), half);
      const V smallest = hn::Add(hn::Mul(p.min_squared(), half), half);
      const Symmetric change = symmetric(p, hn::Mul(found.first, largest), hn::Mul(found.second, smallest));
      SurfaceSums& block = sums[at.block - blocks];
      add_to(change.along, at.k, block.along);
      add_to(change.across, at.k, block.across);
      add_to(change.mixed, at.k, block.mixed);
    }
  }
};

void sweep_surface(const SurfaceLanes& triangles, const BlockRange& range, SurfaceSums* sums, Float4* rows) {
  const SurfaceBlock* blocks = triangles.blocks.data() + range.begin;
  const std::size_t places = (range.end - range.begin) * places_per_block;
  const float relaxation = triangles.relaxation;
  const float short_part = range.is_repeat ? 0.0F : 1.0F;
  if (sums == nullptr) {
    correct(places, Sweep<false>{blocks, nullptr, relaxation, short_part}, as_floats(rows));
  } else {
    correct(places, Sweep<true>{blocks, sums + range.begin, relaxation, short_part}, as_floats(rows));
  }
}

/// Returns `relaxation` times (s - bound) / s over the divisor for singular values s above the bound, 0 for others.
HWY_INLINE V excess_over(V squared, float squared_bound, float relaxation, V divisor) {
  const Floats f;
  const V limit = hn::Set(f, squared_bound);
  const V excess = hn::Sub(squared, limit);
  const V whole = hn::Mul(hn::Add(squared, hn::Sqrt(hn::Mul(squared, limit))), divisor);
  return hn::IfThenElseZero(hn::Gt(excess, hn::Zero(f)), hn::Div(hn::Mul(excess, hn::Set(f, relaxation)), whole));
}

struct Shorten {
  const SurfaceLanes& triangles;
  std::span<const std::uint32_t> blocks;
  float squared_bound;
  float relaxation;

  HWY_INLINE TriangleGroup place(std::size_t i) const {
    const std::uint32_t block = blocks[i / places_per_block];
    return {&triangles.blocks[block], &triangles.projection_mobility[block], i % places_per_block * lanes};
  }

  HWY_INLINE void fetch_block(std::size_t block) const {
    fetch(triangles.blocks[blocks[block]]);
    fetch(triangles.projection_mobility[blocks[block]]);
  }

  HWY_INLINE bool find(const TriangleGroup& at, const float* rows, FoundErrors& found) const {
    const Floats f;
    const V limit = hn::Set(f, squared_bound);
    load_triangles(at, rows, found);
    const Principal& s = found.principal;
    if (hn::AllFalse(f, hn::Gt(s.max_squared(), limit))) return false;
    const Divisors divisors = find_divisors(found.mobility, s);
    found.first = excess_over(s.max_squared(), squared_bound, relaxation, divisors.first);
    found.second = hn::Zero(f);
    if (!hn::AllFalse(f, hn::Gt(s.min_squared(), limit))) {
      found.second = excess_over(s.min_squared(), squared_bound, relaxation, divisors.second);
    }
    return true;
  }

  HWY_INLINE void note(const TriangleGroup&, const FoundErrors&) const {}
};

void shorten_surface(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks, float squared_bound,
                     float relaxation, Float4* rows) {
  correct(blocks.size() * places_per_block, Shorten{triangles, blocks, squared_bound, relaxation}, as_floats(rows));
}

void find_max_surface_ratios(const SurfaceLanes& triangles, std::size_t begin, std::size_t end, const Float4* rows,
                             float* squared_ratios) {
  const Floats f;
  for (std::size_t b = begin; b < end; ++b) {
    const SurfaceBlock& block = triangles.blocks[b];
    if (b + blocks_ahead < end) fetch(triangles.blocks[b + blocks_ahead]);
    V largest = hn::Zero(f);
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const CornerRows corners = load_corners(block, k, as_floats(rows));
      largest = hn::Max(largest, find_principal(gradient_now(block, k, corners)).max_squared());
    }
    squared_ratios[b] = hn::GetLane(hn::MaxOfLanes(f, largest));
  }
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
