// Kernels that find pairs that could meet, for the target being compiled. The file is included once per target, so its
// include guard is of another kind.
#if defined(TAUT_NEAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_NEAR_INL
#undef TAUT_NEAR_INL
#else
#define TAUT_NEAR_INL
#endif

#include <algorithm>
#include <bit>
#include <limits>

#include "sim/solvers/bounded/kernels/boxes_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

HWY_INLINE V clamped_ratio(V part, V whole) {
  const Floats f;
  const V ratio = hn::Div(part, hn::Max(whole, hn::Set(f, min_divisor)));
  return hn::Min(hn::Max(ratio, hn::Zero(f)), hn::Set(f, 1.0F));
}

/// Vector between the closest points, from the second primitive to the first.
struct NearestVector {
  Triple vector;
  V squared_length;
};

HWY_INLINE NearestVector make_nearest_vector(const Triple& vector) { return {vector, dot(vector, vector)}; }

HWY_INLINE NearestVector choose(Mask first, const NearestVector& p, const NearestVector& q) {
  return {{hn::IfThenElse(first, p.vector.x, q.vector.x), hn::IfThenElse(first, p.vector.y, q.vector.y),
           hn::IfThenElse(first, p.vector.z, q.vector.z)},
          hn::IfThenElse(first, p.squared_length, q.squared_length)};
}
HWY_INLINE NearestVector shorter(const NearestVector& p, const NearestVector& q) {
  return choose(hn::Lt(p.squared_length, q.squared_length), p, q);
}

/// Returns the vector from the segment between 0 and `edge`.
HWY_INLINE NearestVector from_segment(const Triple& point, const Triple& edge) {
  return make_nearest_vector(point - edge * clamped_ratio(dot(edge, point), dot(edge, edge)));
}

/// Returns the vector from the nearest of the three edges or, for a vertex above the face, of the face. Rounding moves
/// the closest point within the triangle only, so distances are right even for thin triangles.
HWY_INLINE NearestVector vertex_from_triangle(const Triple (&p)[4]) {
  const Floats f;
  const Triple ab = p[2] - p[1];
  const Triple ac = p[3] - p[1];
  const Triple ap = p[0] - p[1];
  const Triple normal = cross(ab, ac);
  const V divisor = hn::Max(dot(normal, normal), hn::Set(f, min_divisor));
  const V v = hn::Div(dot(cross(ap, ac), normal), divisor);
  const V w = hn::Div(dot(cross(ab, ap), normal), divisor);
  const Mask is_above =
      hn::And(hn::And(hn::Ge(v, hn::Zero(f)), hn::Ge(w, hn::Zero(f))), hn::Le(hn::Add(v, w), hn::Set(f, 1.0F)));
  const NearestVector of_face = make_nearest_vector(ap - ab * v - ac * w);
  const NearestVector of_edges =
      shorter(shorter(from_segment(ap, ab), from_segment(ap, ac)), from_segment(p[0] - p[2], p[3] - p[2]));
  return choose(is_above, shorter(of_face, of_edges), of_edges);
}

/// Returns the shortest vector between the two lines, clamped to one segment, then to the other (Ericson 2005, 5.1.9).
/// Cross products instead of differences of products keep the digits of nearly parallel lines.
HWY_INLINE NearestVector edge_from_edge(const Triple (&p)[4]) {
  const Triple d = p[1] - p[0];
  const Triple e = p[3] - p[2];
  const Triple r = p[0] - p[2];
  const V d_e = dot(d, e);
  const Triple normal = cross(d, e);
  const V first = clamped_ratio(dot(cross(e, r), normal), dot(normal, normal));
  const V t = clamped_ratio(hn::Add(hn::Mul(d_e, first), dot(e, r)), dot(e, e));
  const V s = clamped_ratio(hn::Sub(hn::Mul(d_e, t), dot(d, r)), dot(d, d));
  return make_nearest_vector((r + d * s) - e * t);
}

/// Returns the largest `d` of the first corners plus the largest of the others.
template <std::size_t first_count> HWY_INLINE V sum_of_largest(const Four (&corners)[4]) {
  V first = corners[0].d;
  V second = corners[3].d;
  for (std::size_t k = 1; k < 3; ++k) {
    V& side = k < first_count ? first : second;
    side = hn::Max(side, corners[k].d);
  }
  return hn::Add(first, second);
}

/// Returns whether primitives may come within their radii during their motion. One test uses the line between the
/// closest points: the smallest lead of a corner of one over a corner of the other, before or after. The other uses
/// their distance, which is exact where the line is not.
template <std::size_t first_count>
HWY_INLINE Mask may_meet(const Triple (&points)[4], const Four (&ways)[4], const NearestVector& line) {
  const Floats f;
  V min_ahead = hn::Set(f, std::numeric_limits<float>::infinity());
  V squared_size = hn::Zero(f);
  V squared_approach = hn::Zero(f);
  for (std::size_t k = 0; k < first_count; ++k) {
    for (std::size_t l = first_count; l < 4; ++l) {
      const Triple apart = points[k] - points[l];
      const Triple moved = to_triple(ways[k]) - to_triple(ways[l]);
      const V approach = hn::Min(dot(line.vector, moved), hn::Zero(f));
      min_ahead = hn::Min(min_ahead, hn::Add(dot(line.vector, apart), approach));
      squared_size = hn::Max(squared_size, dot(apart, apart));
      squared_approach = hn::Max(squared_approach, dot(moved, moved));
    }
  }
  const V size = hn::Sqrt(hn::Max(squared_size, squared_approach));
  const V radii = hn::Mul(sum_of_largest<first_count>(ways), hn::Set(f, 1.0F + 1e-5F));
  const V reach = hn::Add(radii, hn::Mul(size, hn::Set(f, 1e-6F)));
  const V farthest = hn::Add(reach, hn::Sqrt(squared_approach));
  return hn::And(hn::Le(min_ahead, hn::Mul(reach, hn::Sqrt(line.squared_length))),
                 hn::Le(line.squared_length, hn::Mul(farthest, farthest)));
}

template <std::size_t first_count>
std::size_t keep_near(const MovingRows& rows, std::size_t count, const PairLists& pairs) {
  for (std::uint32_t* list : pairs) std::fill_n(list + count, lanes, 0U);
  std::size_t kept_count = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    Triple points[4];
    Four ways[4];
    for (std::size_t k = 0; k < 4; ++k) {
      points[k] = as_coordinates(load_rows(as_floats(rows.positions), pairs[k] + i));
      ways[k] = transpose(load_rows(as_floats(rows.motions), pairs[k] + i));
    }
    const NearestVector line = first_count == 1 ? vertex_from_triangle(points) : edge_from_edge(points);
    const Mask near = hn::And(may_meet<first_count>(points, ways, line), lanes_below(i, count));
    for (std::uint32_t bits = mask_bits(near); bits != 0; bits &= bits - 1) {
      for (std::uint32_t* list : pairs) {
        list[kept_count] = list[i + static_cast<std::size_t>(std::countr_zero(bits))];
      }
      ++kept_count;
    }
  }
  return kept_count;
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
