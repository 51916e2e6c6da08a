// Kernels that place the planes of near pairs, for the target being compiled. The file is included once per target, so
// its include guard is of another kind.
#if defined(TAUT_PLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_PLANES_INL
#undef TAUT_PLANES_INL
#else
#define TAUT_PLANES_INL
#endif

#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/kernels/boxes_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

HWY_INLINE Mask is_positive(V v) { return hn::Gt(v, hn::Zero(Floats())); }
HWY_INLINE Mask is_negative(V v) { return hn::Lt(v, hn::Zero(Floats())); }
HWY_INLINE Mask all_of(Mask a, Mask b, Mask c) { return hn::And(hn::And(a, b), c); }
HWY_INLINE V length(const Triple& v) { return hn::Sqrt(dot(v, v)); }
HWY_INLINE Triple divide(const Triple& v, V divisor) {
  return {hn::Div(v.x, divisor), hn::Div(v.y, divisor), hn::Div(v.z, divisor)};
}
HWY_INLINE Triple choose(Mask first, const Triple& p, const Triple& q) {
  return {hn::IfThenElse(first, p.x, q.x), hn::IfThenElse(first, p.y, q.y), hn::IfThenElse(first, p.z, q.z)};
}
/// Returns 1 or, where the value is negative, -1.
HWY_INLINE V sign(V v) {
  const Floats f;
  return hn::IfThenElse(is_negative(v), hn::Set(f, -1.0F), hn::Set(f, 1.0F));
}

/// Returns part / whole, clamped to 0 and 1; 0 where the whole is not positive.
HWY_INLINE V clamped_fraction(V part, V whole) {
  const Floats f;
  const V one = hn::Set(f, 1.0F);
  const V ratio = hn::IfThenZeroElse(is_negative(part), hn::Div(part, whole));
  return hn::IfThenElseZero(is_positive(whole), hn::IfThenElse(hn::Gt(ratio, one), one, ratio));
}

/// Weights of the corners at the closest points, see ClosestWeights.
struct Weights {
  V of[4];
};

HWY_INLINE void set_where(Mask where, V b0, V b1, V b2, Weights& weights) {
  weights.of[1] = hn::IfThenElse(where, b0, weights.of[1]);
  weights.of[2] = hn::IfThenElse(where, b1, weights.of[2]);
  weights.of[3] = hn::IfThenElse(where, b2, weights.of[3]);
}

// The operations of closest_vertex_triangle(), in their order. Regions are tested in the reverse order, so that the
// first one there that holds the point is kept.
HWY_INLINE Weights closest_in_triangle(const Triple (&p)[4]) {
  const Floats f;
  const V zero = hn::Zero(f);
  const V one = hn::Set(f, 1.0F);
  const Triple ab = p[2] - p[1];
  const Triple ac = p[3] - p[1];
  const Triple ap = p[0] - p[1];
  const Triple bp = p[0] - p[2];
  const Triple cp = p[0] - p[3];
  const V d1 = dot(ab, ap), d2 = dot(ac, ap);
  const V d3 = dot(ab, bp), d4 = dot(ac, bp);
  const V d5 = dot(ab, cp), d6 = dot(ac, cp);
  const V va = hn::Sub(hn::Mul(d3, d6), hn::Mul(d5, d4));
  const V vb = hn::Sub(hn::Mul(d5, d2), hn::Mul(d1, d6));
  const V vc = hn::Sub(hn::Mul(d1, d4), hn::Mul(d3, d2));
  const V sum = hn::Add(hn::Add(va, vb), vc);
  const V v = hn::Div(vb, sum);
  const V w = hn::Div(vc, sum);
  Weights weights = {{one, hn::Sub(hn::Sub(one, v), w), v, w}};
  const V after_b = hn::Sub(d4, d3);
  const V before_c = hn::Sub(d5, d6);
  const V on_bc = clamped_fraction(after_b, hn::Add(after_b, before_c));
  set_where(all_of(hn::Le(va, zero), hn::Ge(after_b, zero), hn::Ge(before_c, zero)), zero, hn::Sub(one, on_bc), on_bc,
            weights);
  const V on_ac = clamped_fraction(d2, hn::Sub(d2, d6));
  set_where(all_of(hn::Le(vb, zero), hn::Ge(d2, zero), hn::Le(d6, zero)), hn::Sub(one, on_ac), zero, on_ac, weights);
  set_where(hn::And(hn::Ge(d6, zero), hn::Le(d5, d6)), zero, zero, one, weights);
  const V on_ab = clamped_fraction(d1, hn::Sub(d1, d3));
  set_where(all_of(hn::Le(vc, zero), hn::Ge(d1, zero), hn::Le(d3, zero)), hn::Sub(one, on_ab), on_ab, zero, weights);
  set_where(hn::And(hn::Ge(d3, zero), hn::Le(d4, d3)), zero, one, zero, weights);
  set_where(hn::And(hn::Le(d1, zero), hn::Le(d2, zero)), one, zero, zero, weights);
  return weights;
}

HWY_INLINE Weights closest_on_edges(const Triple (&p)[4]) {
  const V one = hn::Set(Floats(), 1.0F);
  const Triple d1 = p[1] - p[0];
  const Triple d2 = p[3] - p[2];
  const Triple r = p[0] - p[2];
  const V a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r), b = dot(d1, d2);
  const V line = clamped_fraction(hn::Sub(hn::Mul(b, f), hn::Mul(c, e)), hn::Sub(hn::Mul(a, e), hn::Mul(b, b)));
  const V t = clamped_fraction(hn::Add(hn::Mul(b, line), f), e);
  const V s = clamped_fraction(hn::Sub(hn::Mul(b, t), c), a);
  return {{hn::Sub(one, s), s, hn::Sub(one, t), t}};
}

template <std::size_t first_count> HWY_INLINE Weights closest(const Triple (&p)[4]) {
  return first_count == 1 ? closest_in_triangle(p) : closest_on_edges(p);
}

/// Returns the vector from the second primitive to the first at the closest points.
template <std::size_t first_count> HWY_INLINE Triple between(const Triple (&p)[4], const Weights& weights) {
  const Floats f;
  Triple sum = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
  for (std::size_t k = 0; k < 4; ++k) {
    sum = sum + (p[k] - p[0]) * (k < first_count ? weights.of[k] : hn::Neg(weights.of[k]));
  }
  return sum;
}

/// Plane normals of pairs, and the corners' heights along them.
struct Heights {
  Triple normal;
  V of[4];
  V apart;         ///< lowest corner of the first primitive above the highest of the second
  V apart_at_end;  ///< the same after the predicted motion
};

template <std::size_t first_count> HWY_INLINE V lead(const V (&heights)[4]) {
  const V low = first_count == 1 ? heights[0] : hn::Min(heights[0], heights[1]);
  const V high = hn::Max(heights[2], heights[3]);
  return hn::Sub(low, first_count == 1 ? hn::Max(heights[1], high) : high);
}

template <std::size_t first_count>
HWY_INLINE Heights heights_along(const Triple& normal, const Triple (&p)[4], const Triple (&moves)[4]) {
  Heights heights = {normal, {}, {}, {}};
  V at_end[4];
  for (std::size_t k = 0; k < 4; ++k) {
    heights.of[k] = dot(normal, p[k] - p[0]);
    at_end[k] = hn::Add(heights.of[k], dot(normal, moves[k]));
  }
  heights.apart = lead<first_count>(heights.of);
  heights.apart_at_end = lead<first_count>(at_end);
  return heights;
}

HWY_INLINE Heights choose(Mask first, const Heights& p, const Heights& q) {
  Heights chosen = {choose(first, p.normal, q.normal),
                    {},
                    hn::IfThenElse(first, p.apart, q.apart),
                    hn::IfThenElse(first, p.apart_at_end, q.apart_at_end)};
  for (std::size_t k = 0; k < 4; ++k) chosen.of[k] = hn::IfThenElse(first, p.of[k], q.of[k]);
  return chosen;
}

/// Returns the normal of the triangle or of both edges, on the side of `line`. It has the direction of `line` if the
/// closest points are inner points, and it is accurate where `line` is not.
template <std::size_t first_count> HWY_INLINE Triple normal_across(const Triple (&p)[4], const Triple& line) {
  const Triple across = first_count == 2 ? cross(p[1] - p[0], p[3] - p[2]) : cross(p[2] - p[1], p[3] - p[1]);
  return across * hn::Div(sign(dot(across, line)), length(across));
}

/// Returns the mean surface normal of both primitives, on the side of the first; 0 / 0 where it is at right angles to
/// `line`.
template <std::size_t first_count>
HWY_INLINE Triple mean_surface_normal(const Triple (&p)[4], const Triple (&normals)[4], const Triple& line) {
  const Triple first = first_count == 1 ? normals[0] : normals[0] + normals[1];
  const Triple second = first_count == 1 ? cross(p[2] - p[1], p[3] - p[1]) : normals[2] + normals[3];
  const Triple sum = first * hn::Div(sign(dot(first, line)), length(first)) +
                     second * hn::Div(sign(dot(second, line)), length(second));
  return divide(sum, length(sum));
}

/// Returns distance_error_m() of pairs.
HWY_INLINE V distance_error(const Triple (&p)[4], const Four (&extents)[4], float displaced) {
  const Floats f;
  V from_origin = hn::Zero(f), moved = hn::Zero(f), squared_across = hn::Zero(f);
  for (std::size_t k = 0; k < 4; ++k) {
    from_origin = hn::Max(from_origin, extents[k].a);
    moved = hn::Max(moved, extents[k].b);
    const Triple across = p[k] - p[0];
    squared_across = hn::Max(squared_across, dot(across, across));
  }
  constexpr PairExtent weights = error_weights;
  const V sum = hn::Add(hn::Add(hn::Add(hn::Mul(hn::Set(f, weights.from_origin), from_origin),
                                        hn::Mul(hn::Set(f, weights.across), hn::Sqrt(squared_across))),
                                hn::Mul(hn::Set(f, weights.moved), moved)),
                        hn::Set(f, weights.displaced * displaced));
  return hn::Add(hn::Set(f, 2.0F * tolerance_m), hn::Mul(hn::Set(f, unit_roundoff), sum));
}

/// Returns planned_gap_m() of pairs.
HWY_INLINE V planned_gap(V thickness, V error) {
  const Floats f;
  return hn::Max(hn::Mul(hn::Set(f, min_gap_fraction), thickness), hn::Mul(hn::Set(f, 2.0F), error));
}

/// Sliding layers pass over each other's inner edges. A plane at right angles to the shortest distance would block
/// sliding there as if the edge were a step. So planes of pairs that may touch lie along both surfaces if that leaves
/// more room.
template <std::size_t first_count>
HWY_INLINE Heights level(const Heights& heights, const Triple (&p)[4], const Triple (&moves)[4], const PairRows& rows,
                         const std::uint32_t* const (&at)[4], V thickness, V error) {
  const Floats f;
  const V of_thin_cloth = hn::Sub(hn::Set(f, thinnest_collision_distance_m),
                                  hn::Mul(hn::Set(f, tuning::decrease_per_thickness), thickness));
  const V collision_distance = hn::Max(hn::Mul(hn::Set(f, collision_distance_per_thickness), thickness), of_thin_cloth);
  Mask may_touch = hn::Not(hn::Gt(hn::Min(heights.apart_at_end, heights.apart), collision_distance));
  if (hn::AllFalse(f, may_touch)) return heights;
  Triple normals[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const Four normal = transpose(load_rows(as_floats(rows.normals), at[k]));
    normals[k] = to_triple(normal);
    may_touch = hn::And(may_touch, is_positive(normal.d));
  }
  const Triple normal = mean_surface_normal<first_count>(p, normals, heights.normal);
  const Heights levelled = heights_along<first_count>(normal, p, moves);
  const Mask is_resolved = hn::Gt(levelled.apart, hn::Mul(hn::Set(f, 2.0F), planned_gap(thickness, error)));
  const auto lack = [&](const Heights& of) { return hn::Sub(hn::Min(of.apart, thickness), of.apart_at_end); };
  return choose(all_of(may_touch, is_resolved, hn::Lt(lack(levelled), lack(heights))), levelled, heights);
}

template <std::size_t first_count> void place_planes(const PairRows& rows, PairBlock& pairs) {
  const Floats f;
  for (std::size_t i = 0; i < block_size; i += lanes) {
    const std::uint32_t* const at[4] = {&pairs.at[0][i], &pairs.at[1][i], &pairs.at[2][i], &pairs.at[3][i]};
    Triple p[4];
    Triple moves[4];
    Four extents[4];
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = as_coordinates(load_rows(as_floats(rows.positions), at[k]));
      moves[k] = as_coordinates(load_rows(as_floats(rows.moves), at[k]));
      extents[k] = transpose(load_rows(as_floats(rows.extents), at[k]));
    }
    const Weights weights = closest<first_count>(p);
    const Triple line = between<first_count>(p, weights);
    const V distance = length(line);
    Heights heights = heights_along<first_count>(divide(line, distance), p, moves);
    // If primitives are far longer than their distance, rounding turns the line between their closest points.
    const Mask is_turned = hn::Not(hn::Gt(heights.apart, hn::Mul(hn::Set(f, min_resolved_fraction), distance)));
    if (!hn::AllFalse(f, is_turned)) {
      const Heights across = heights_along<first_count>(normal_across<first_count>(p, line), p, moves);
      heights = choose(hn::And(is_turned, hn::Gt(across.apart, heights.apart)), across, heights);
    }
    const V error = distance_error(p, extents, rows.displaced);
    heights = level<first_count>(heights, p, moves, rows, at, hn::Load(f, &pairs.thickness[i]), error);
    hn::Store(heights.normal.x, f, &pairs.normal[0][i]);
    hn::Store(heights.normal.y, f, &pairs.normal[1][i]);
    hn::Store(heights.normal.z, f, &pairs.normal[2][i]);
    for (std::size_t k = 0; k < 4; ++k) {
      hn::Store(heights.of[k], f, &pairs.heights[k][i]);
      hn::Store(weights.of[k], f, &pairs.weights[k][i]);
    }
    hn::Store(heights.apart, f, &pairs.distance[i]);
    hn::Store(error, f, &pairs.error[i]);
  }
}

template <std::size_t first_count> void measure_distances(const Float4* positions, PairBlock& pairs) {
  const Floats f;
  for (std::size_t i = 0; i < block_size; i += lanes) {
    Triple p[4];
    for (std::size_t k = 0; k < 4; ++k) p[k] = as_coordinates(load_rows(as_floats(positions), &pairs.at[k][i]));
    hn::Store(length(between<first_count>(p, closest<first_count>(p))), f, &pairs.distance[i]);
  }
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
