// The kernels that find which pairs could meet, for the target being compiled. The file is included once per
// target, so its include guard is of another kind.
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

HWY_INLINE V part_of(V part, V whole) {
  const Floats f;
  const V ratio = hn::Div(part, hn::Max(whole, hn::Set(f, smallest_divisor)));
  return hn::Min(hn::Max(ratio, hn::Zero(f)), hn::Set(f, 1.0F));
}

/// From the nearest point of the other thing to that of the one.
struct Between {
  Triple vector;
  V squared_length;
};

HWY_INLINE Between between(const Triple& vector) { return {vector, dot(vector, vector)}; }

HWY_INLINE Between choose(Mask first, const Between& p, const Between& q) {
  return {{hn::IfThenElse(first, p.vector.x, q.vector.x), hn::IfThenElse(first, p.vector.y, q.vector.y),
           hn::IfThenElse(first, p.vector.z, q.vector.z)},
          hn::IfThenElse(first, p.squared_length, q.squared_length)};
}
HWY_INLINE Between shorter(const Between& p, const Between& q) {
  return choose(hn::Lt(p.squared_length, q.squared_length), p, q);
}

/// From the segment between 0 and `edge`.
HWY_INLINE Between from_segment(const Triple& point, const Triple& edge) {
  return between(point - edge * part_of(dot(edge, point), dot(edge, edge)));
}

/// The nearest of the three edges and, for a vertex above the face, of the face. Rounding moves the nearest
/// point within the triangle alone, so that distances come out right even where triangles are thin.
HWY_INLINE Between vertex_from_triangle(const Triple (&p)[4]) {
  const Floats f;
  const Triple ab = p[2] - p[1];
  const Triple ac = p[3] - p[1];
  const Triple ap = p[0] - p[1];
  const Triple normal = cross(ab, ac);
  const V divisor = hn::Max(dot(normal, normal), hn::Set(f, smallest_divisor));
  const V v = hn::Div(dot(cross(ap, ac), normal), divisor);
  const V w = hn::Div(dot(cross(ab, ap), normal), divisor);
  const Mask is_above =
      hn::And(hn::And(hn::Ge(v, hn::Zero(f)), hn::Ge(w, hn::Zero(f))), hn::Le(hn::Add(v, w), hn::Set(f, 1.0F)));
  const Between of_face = between(ap - ab * v - ac * w);
  const Between of_edges =
      shorter(shorter(from_segment(ap, ab), from_segment(ap, ac)), from_segment(p[0] - p[2], p[3] - p[2]));
  return choose(is_above, shorter(of_face, of_edges), of_edges);
}

/// Returns the shortest vector between the two lines, clamped to the one segment, then to the other (Ericson
/// 2005, 5.1.9). Cross products instead of differences of products keep the digits of lines that are nearly parallel.
HWY_INLINE Between edge_from_edge(const Triple (&p)[4]) {
  const Triple d = p[1] - p[0];
  const Triple e = p[3] - p[2];
  const Triple r = p[0] - p[2];
  const V d_e = dot(d, e);
  const Triple normal = cross(d, e);
  const V first = part_of(dot(cross(e, r), normal), dot(normal, normal));
  const V t = part_of(hn::Add(hn::Mul(d_e, first), dot(e, r)), dot(e, e));
  const V s = part_of(hn::Sub(hn::Mul(d_e, t), dot(d, r)), dot(d, d));
  return between((r + d * s) - e * t);
}

/// Returns the sum of the largest `d` of the first and of the other corners.
template <std::size_t first_count> HWY_INLINE V sum_of_largest(const Four (&corners)[4]) {
  V first = corners[0].d;
  V second = corners[3].d;
  for (std::size_t k = 1; k < 3; ++k) {
    V& side = k < first_count ? first : second;
    side = hn::Max(side, corners[k].d);
  }
  return hn::Add(first, second);
}

/// Returns whether things may come within their radii of each other on their ways: by the direction between
/// their nearest points, the least that a corner of the one is ahead of one of the other, before or after.
/// And by their distance, which is exact where that direction is not.
template <std::size_t first_count>
HWY_INLINE Mask may_meet(const Triple (&points)[4], const Four (&ways)[4], const Between& line) {
  const Floats f;
  V least = hn::Set(f, std::numeric_limits<float>::infinity());
  V squared_size = hn::Zero(f);
  V squared_approach = hn::Zero(f);
  for (std::size_t k = 0; k < first_count; ++k) {
    for (std::size_t l = first_count; l < 4; ++l) {
      const Triple apart = points[k] - points[l];
      const Triple moved = coordinates_of(ways[k]) - coordinates_of(ways[l]);
      const V approach = hn::Min(dot(line.vector, moved), hn::Zero(f));
      least = hn::Min(least, hn::Add(dot(line.vector, apart), approach));
      squared_size = hn::Max(squared_size, dot(apart, apart));
      squared_approach = hn::Max(squared_approach, dot(moved, moved));
    }
  }
  const V size = hn::Sqrt(hn::Max(squared_size, squared_approach));
  const V radii = hn::Mul(sum_of_largest<first_count>(ways), hn::Set(f, 1.0F + 1e-5F));
  const V reach = hn::Add(radii, hn::Mul(size, hn::Set(f, 1e-6F)));
  const V farthest = hn::Add(reach, hn::Sqrt(squared_approach));
  return hn::And(hn::Le(least, hn::Mul(reach, hn::Sqrt(line.squared_length))),
                 hn::Le(line.squared_length, hn::Mul(farthest, farthest)));
}

template <std::size_t first_count>
std::size_t keep_near(const MovingRows& rows, std::size_t count, const PairLists& pairs) {
  for (std::uint32_t* list : pairs) std::fill_n(list + count, lanes, 0U);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    Triple points[4];
    Four ways[4];
    for (std::size_t k = 0; k < 4; ++k) {
      points[k] = as_coordinates(load_rows(floats_of(rows.places), pairs[k] + i));
      ways[k] = transposed(load_rows(floats_of(rows.ways), pairs[k] + i));
    }
    const Between line = first_count == 1 ? vertex_from_triangle(points) : edge_from_edge(points);
    const Mask near = hn::And(may_meet<first_count>(points, ways, line), lanes_below(i, count));
    for (std::uint32_t bits = bits_of(near); bits != 0; bits &= bits - 1) {
      for (std::uint32_t* list : pairs) {
        list[kept] = list[i + static_cast<std::size_t>(std::countr_zero(bits))];
      }
      ++kept;
    }
  }
  return kept;
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
