#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace taut::app::test {

// Crossing of triangles with small whole coordinates, by another method than the program's. It computes in whole
// numbers: convex sets are apart if and only if an axis separates them (Gottschalk, Lin and Manocha 1996).

using Whole = std::array<std::int64_t, 3>;
using WholeCorners = std::array<Whole, 3>;

inline Whole minus(const Whole& a, const Whole& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline std::int64_t dot(const Whole& a, const Whole& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline std::vector<Whole> sides(std::span<const Whole> points) {
  std::vector<Whole> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all.push_back(minus(points[(i + 1) % points.size()], points[i]));
  }
  return all;
}

inline bool separates(const Whole& axis, std::span<const Whole> a, std::span<const Whole> b) {
  std::int64_t most_a = dot(axis, a[0]), least_b = dot(axis, b[0]);
  for (const Whole& p : a) {
    most_a = std::max(most_a, dot(axis, p));
  }
  for (const Whole& p : b) {
    least_b = std::min(least_b, dot(axis, p));
  }
  return most_a < least_b;
}

/// Returns whether the convex hulls of up to three points each have no point in common. If so, the direction of their
/// smallest distance separates them. It joins two corners, or is at right angles to a side in the plane of a corner,
/// or to two sides.
inline bool are_apart(std::span<const Whole> a, std::span<const Whole> b) {
  std::vector<Whole> edges = sides(a), axes;
  const std::vector<Whole> sides_of_b = sides(b);
  edges.insert(edges.end(), sides_of_b.begin(), sides_of_b.end());
  for (const Whole& p : a) {
    for (const Whole& q : b) {
      axes.push_back(minus(q, p));
      for (const Whole& side : edges) {
        axes.push_back(cross(side, cross(side, minus(q, p))));
      }
    }
  }
  for (const Whole& one : edges) {
    for (const Whole& other : edges) {
      axes.push_back(cross(one, other));
    }
  }
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Whole& axis) { return separates(axis, a, b) || separates(axis, b, a); });
}

/// Returns whether two triangles with area cross. Their first `shared` corners are the same vertices.
inline bool do_cross(const WholeCorners& a, const WholeCorners& b, std::size_t shared) {
  if (shared == 0) {
    return !are_apart(a, b);
  }
  if (shared == 1) {
    return !are_apart(std::span(a).subspan(1), b) || !are_apart(a, std::span(b).subspan(1));
  }
  const Whole edge = minus(a[1], a[0]);
  const Whole n = cross(edge, minus(a[2], a[0])), m = cross(edge, minus(b[2], b[0]));
  return cross(n, m) == Whole{} && dot(n, m) > 0;
}

inline bool has_area(const WholeCorners& t) {
  return cross(minus(t[1], t[0]), minus(t[2], t[0])) != Whole{};
}

}  // namespace taut::app::test
