// The kernels that hold the stretch of triangles, for the target being compiled. The file is included once
// per target, so its include guard is of another kind.
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

/// Three corners of `lanes` triangles, as rows.
struct Corners {
  Four a, b, c;
};

/// A deformation gradient F: its columns.
struct Gradient {
  Triple along, across;
};

HWY_INLINE Corners load_corners(const SurfaceBlock& block, std::size_t k, const float* rows) {
  return {load_rows(rows, &block.at[0][k]), load_rows(rows, &block.at[1][k]),
          load_rows(rows, &block.at[2][k])};
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

/// Returns F of edges e1 and e2, or what displacements between corners add to it.
HWY_INLINE Gradient gradient_of(const SurfaceBlock& block, std::size_t k, const Triple& e1,
                                const Triple& e2) {
  const Floats f;
  return {e1 * hn::Load(f, &block.along_per_m[k]),
          e2 * hn::Load(f, &block.across_per_m[k]) - e1 * hn::Load(f, &block.skew_per_m[k])};
}

HWY_INLINE Gradient gradient_now(const SurfaceBlock& block, std::size_t k, const Corners& corners) {
  const Gradient moved =
      gradient_of(block, k, as_coordinates(corners.b - corners.a), as_coordinates(corners.c - corners.a));
  return {moved.along + load_triple(block.start_along, k), moved.across + load_triple(block.start_across, k)};
}

/// The squared singular values of F are mean + radius and mean - radius. The cosine and the sine of twice the
/// angle of the largest's direction are difference / radius and product / radius.
struct Principal {
  V mean, radius;
  V difference, product;

  HWY_INLINE V largest() const { return hn::Add(mean, radius); }
  HWY_INLINE V smallest() const { return hn::Sub(mean, radius); }
};

HWY_INLINE Principal principal_of(const Gradient& gradient) {
  const Floats f;
  const V half = hn::Set(f, 0.5F);
  const V a = dot(gradient.along, gradient.along);
  const V b = dot(gradient.along, gradient.across);
  const V c = dot(gradient.across, gradient.across);
  const V difference = hn::Mul(hn::Sub(a, c), half);
  const V radius = hn::Sqrt(hn::Add(hn::Mul(difference, difference), hn::Mul(b, b)));
  return {hn::Mul(hn::Add(a, c), half), hn::Max(radius, hn::Set(f, least_radius)), difference, b};
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

/// The sums of w (g v)^2 in both principal directions, times the radius.
struct Divisors {
  V first, second;
};

HWY_INLINE Divisors divisors_of(const Mobility& mobility, const Principal& p) {
  const V middle = hn::Mul(p.radius, hn::Set(Floats(), 0.5F + least_mobility));
  const V to_first =
      hn::Add(hn::Mul(mobility.along_less_across, p.difference), hn::Mul(mobility.skew, p.product));
  return {hn::Add(middle, to_first), hn::Sub(middle, to_first)};
}

/// `first` and `second` are the errors in the two directions over the divisors.
HWY_INLINE void move_corners(const SurfaceBlock& block, std::size_t k, const Corners& corners,
                             const Gradient& gradient, const Principal& p, V first, V second,
                             const Mobility& mobility, float* rows) {
  const Floats f;
  const V half = hn::Set(f, 0.5F);
  const V mean = hn::Mul(hn::Mul(hn::Add(first, second), half), p.radius);
  const V half_difference = hn::Mul(hn::Sub(first, second), half);
  // The symmetric matrix with these values in these directions. F times it is the change of F.
  const V cosine = hn::Mul(half_difference, p.difference);
  const V s11 = hn::Add(mean, cosine);
  const V s22 = hn::Sub(mean, cosine);
  const V s12 = hn::Mul(half_difference, p.product);
  const V along = hn::Load(f, &block.along_per_m[k]);
  const V across = hn::Load(f, &block.across_per_m[k]);
  const V skew = hn::Load(f, &block.skew_per_m[k]);
  const Triple b = gradient.along * hn::Sub(hn::Mul(along, s11), hn::Mul(skew, s12)) +
                   gradient.across * hn::Sub(hn::Mul(along, s12), hn::Mul(skew, s22));
  const Triple c = gradient.along * hn::Mul(across, s12) + gradient.across * hn::Mul(across, s22);
  store_rows(corners.a + as_rows((b + c) * mobility.a), rows, &block.at[0][k]);
  store_rows(corners.b - as_rows(b * mobility.b), rows, &block.at[1][k]);
  store_rows(corners.c - as_rows(c * mobility.c), rows, &block.at[2][k]);
}

void start_surface(const StartRows& start, std::size_t begin, std::size_t end, SurfaceLanes& triangles) {
  for (std::size_t b = begin; b < end; ++b) {
    SurfaceBlock& block = triangles.blocks[b];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Corners high = load_corners(block, k, floats_of(start.high.data()));
      const Corners low = load_corners(block, k, floats_of(start.low.data()));
      const Triple e1 = as_coordinates((high.b - high.a) + (low.b - low.a));
      const Triple e2 = as_coordinates((high.c - high.a) + (low.c - low.a));
      const Gradient gradient = gradient_of(block, k, e1, e2);
      store_triple(gradient.along, k, block.start_along);
      store_triple(gradient.across, k, block.start_across);
    }
  }
}

/// Some triangles of a block: those of lanes k, k + 1, ...
struct Place {
  const SurfaceBlock* block;
  std::size_t k;
};

/// Triangles as loaded, and the errors in both directions over the divisors.
struct Answer {
  Corners corners;
  Gradient gradient;
  Principal principal;
  Mobility mobility;
  V first, second;
};

HWY_INLINE void find_errors(const Place& at, const float* rows, Answer& answer) {
  const Floats f;
  const V one = hn::Set(f, 1.0F);
  answer.corners = load_corners(*at.block, at.k, rows);
  answer.gradient = gradient_now(*at.block, at.k, answer.corners);
  const Principal s = answer.principal = principal_of(answer.gradient);
  answer.mobility = load_mobility(at.block->mobility, at.k);
  const Divisors divisors = divisors_of(answer.mobility, s);
  const V first_divisor = hn::Mul(hn::Add(s.largest(), one), divisors.first);
  const V second_divisor = hn::Mul(hn::Add(s.smallest(), one), divisors.second);
  const V per_both = hn::Div(one, hn::Mul(first_divisor, second_divisor));
  const V first = hn::Mul(hn::Mul(hn::Sub(s.largest(), one), second_divisor), per_both);
  const V second = hn::Mul(hn::Mul(hn::Sub(s.smallest(), one), first_divisor), per_both);
  // A share is at most 1. So the larger value is the whole error where the triangle is too long, and the
  // share of it otherwise.
  const V share = hn::Load(f, &at.block->short_share[at.k]);
  answer.first = hn::Max(first, hn::Mul(first, share));
  answer.second = hn::Max(second, hn::Mul(second, share));
}

/// Two at a time, so that one is computed while the other waits for a square root or a division.
HWY_INLINE void sweep_both(const Place& a, const Place& b, float* rows) {
  Answer at_a, at_b;
  find_errors(a, rows, at_a);
  find_errors(b, rows, at_b);
  move_corners(*a.block, a.k, at_a.corners, at_a.gradient, at_a.principal, at_a.first, at_a.second,
               at_a.mobility, rows);
  move_corners(*b.block, b.k, at_b.corners, at_b.gradient, at_b.principal, at_b.first, at_b.second,
               at_b.mobility, rows);
}

HWY_INLINE void sweep_one(const Place& a, float* rows) {
  Answer at_a;
  find_errors(a, rows, at_a);
  move_corners(*a.block, a.k, at_a.corners, at_a.gradient, at_a.principal, at_a.first, at_a.second,
               at_a.mobility, rows);
}

void sweep_surface(const SurfaceLanes& triangles, std::size_t begin, std::size_t end, Float4* rows) {
  float* first_row = floats_of(rows);
  const SurfaceBlock* block = triangles.blocks.data() + begin;
  const SurfaceBlock* const last = triangles.blocks.data() + end;
  if constexpr (lanes == block_size) {
    for (; block + 1 < last; block += 2) {
      sweep_both({block, 0}, {block + 1, 0}, first_row);
    }
    if (block != last) {
      sweep_one({block, 0}, first_row);
    }
  } else {
    for (; block != last; ++block) {
      for (std::size_t k = 0; k < block_size; k += 2 * lanes) {
        sweep_both({block, k}, {block, k + lanes}, first_row);
      }
    }
  }
}

/// Returns (s - bound) / s of a singular value above the bound, 0 of others.
HWY_INLINE V relative_excess(V squared, float squared_bound) {
  const Floats f;
  const V limit = hn::Set(f, squared_bound);
  const V excess = hn::Sub(squared, limit);
  return hn::IfThenElseZero(hn::Gt(excess, hn::Zero(f)),
                            hn::Div(excess, hn::Add(squared, hn::Sqrt(hn::Mul(squared, limit)))));
}

void shorten_surface(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks,
                     float squared_bound, float relaxation, Float4* rows) {
  const Floats f;
  const V factor = hn::Set(f, relaxation);
  float* first_row = floats_of(rows);
  for (const std::uint32_t b : blocks) {
    const SurfaceBlock& block = triangles.blocks[b];
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Corners corners = load_corners(block, k, first_row);
      const Gradient gradient = gradient_now(block, k, corners);
      const Principal s = principal_of(gradient);
      if (hn::AllFalse(f, hn::Gt(s.largest(), hn::Set(f, squared_bound)))) {
        continue;
      }
      const Mobility mobility = load_mobility(triangles.projection_mobility[b], k);
      const Divisors divisors = divisors_of(mobility, s);
      const V first = hn::Div(hn::Mul(relative_excess(s.largest(), squared_bound), factor), divisors.first);
      const V second =
          hn::Div(hn::Mul(relative_excess(s.smallest(), squared_bound), factor), divisors.second);
      move_corners(block, k, corners, gradient, s, first, second, mobility, first_row);
    }
  }
}

void largest_surface_ratios(const SurfaceLanes& triangles, std::size_t begin, std::size_t end,
                            const Float4* rows, float* squared_ratios) {
  const Floats f;
  for (std::size_t b = begin; b < end; ++b) {
    const SurfaceBlock& block = triangles.blocks[b];
    V largest = hn::Zero(f);
    for (std::size_t k = 0; k < block_size; k += lanes) {
      const Corners corners = load_corners(block, k, floats_of(rows));
      largest = hn::Max(largest, principal_of(gradient_now(block, k, corners)).largest());
    }
    squared_ratios[b] = hn::GetLane(hn::MaxOfLanes(f, largest));
  }
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
