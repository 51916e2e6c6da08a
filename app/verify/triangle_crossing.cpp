#include "app/verify/triangle_crossing.hpp"

namespace taut::app {

namespace {

using sim::Vec2;
using sim::Vec3;

/// A closed segment; a point if its ends are equal.
struct TriangleEdge {
  Vec3 from, to;
};

TriangleEdge triangle_edge(const Corners& t, std::size_t k) { return {t[k], t[(k + 1) % 3]}; }

Vec2 without(int axis, const Vec3& p) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

int orientation_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation(without(axis, a), without(axis, b), without(axis, c));
}

bool is_without_area(const Corners& t) {
  return orientation_without(0, t[0], t[1], t[2]) == 0 && orientation_without(1, t[0], t[1], t[2]) == 0 &&
         orientation_without(2, t[0], t[1], t[2]) == 0;
}

/// Returns the intersection of the bounding boxes. An empty one has `from` above `to` in some coordinate.
TriangleEdge common_box(const TriangleEdge& s, const TriangleEdge& t) {
  return {glm::max(glm::min(s.from, s.to), glm::min(t.from, t.to)),
          glm::min(glm::max(s.from, s.to), glm::max(t.from, t.to))};
}

bool boxes_meet(const TriangleEdge& s, const TriangleEdge& t) {
  const TriangleEdge box = common_box(s, t);
  return box.from.x <= box.to.x && box.from.y <= box.to.y && box.from.z <= box.to.z;
}

/// Requires segments whose bounding boxes meet, which is enough for segments on one line.
bool projections_meet(int axis, const TriangleEdge& s, const TriangleEdge& t) {
  return orientation_without(axis, s.from, s.to, t.from) * orientation_without(axis, s.from, s.to, t.to) <= 0 &&
         orientation_without(axis, t.from, t.to, s.from) * orientation_without(axis, t.from, t.to, s.to) <= 0;
}

/// Returns whether segments meet. Segments in one plane meet if and only if all three of their projections meet: at
/// least one projection maps the plane one to one.
bool segments_meet(const TriangleEdge& s, const TriangleEdge& t) {
  return boxes_meet(s, t) && projections_meet(0, s, t) && projections_meet(1, s, t) && projections_meet(2, s, t) &&
         orientation(s.from, s.to, t.from, t.to) == 0;
}

/// Returns the common point of two segments that meet; on one line, the middle of their common part.
Vec3 meeting_place(const TriangleEdge& s, const TriangleEdge& t) {
  const Vec3 along_s = s.to - s.from, along_t = t.to - t.from;
  const Vec3 normal = glm::cross(along_s, along_t);
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0)) {
    const TriangleEdge box = common_box(s, t);
    return 0.5 * (box.from + box.to);
  }
  const double at = glm::dot(glm::cross(t.from - s.from, along_t), normal) / square;
  return s.from + std::clamp(at, 0.0, 1.0) * along_s;
}

/// Returns whether a point in the triangle's plane is inside, off the edges; false for a triangle without area.
bool is_inside(const Vec3& p, const Corners& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const int side = orientation_without(axis, t[0], t[1], p);
    if (side != 0 && orientation_without(axis, t[1], t[2], p) == side &&
        orientation_without(axis, t[2], t[0], p) == side) {
      return true;
    }
  }
  return false;
}

/// Requires a segment in the triangle's plane, or a triangle without area.
std::optional<Vec3> place_in_plane(const TriangleEdge& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (segments_meet(s, triangle_edge(t, k))) return meeting_place(s, triangle_edge(t, k));
  }
  return is_inside(s.from, t) ? std::optional(s.from) : std::nullopt;
}

double distance_from_plane(const Vec3& p, const Corners& t) {
  return std::abs(glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), p - t[0]));
}

/// Sides of a triangle's plane on which two points are.
struct SidesOfEnds {
  int first, second;

  bool are_one() const { return first * second > 0; }
  bool are_none() const { return first == 0 && second == 0; }
};

int orientation_sign(const Corners& plane, const Vec3& p) { return orientation(plane[0], plane[1], plane[2], p); }

SidesOfEnds orientation_signs(const Corners& plane, const Vec3& a, const Vec3& b) {
  return {orientation_sign(plane, a), orientation_sign(plane, b)};
}

/// Returns a common point of the triangle and the segment, whose ends are on these sides.
std::optional<Vec3> common_place(const TriangleEdge& s, const SidesOfEnds& sides, const Corners& t) {
  if (sides.are_one()) return std::nullopt;
  if (sides.are_none()) return place_in_plane(s, t);
  bool is_left = false, is_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = orientation(s.from, s.to, triangle_edge(t, k).from, triangle_edge(t, k).to);
    is_left = is_left || side > 0;
    is_right = is_right || side < 0;
  }
  if (is_left && is_right) return std::nullopt;
  const double before = distance_from_plane(s.from, t), behind = distance_from_plane(s.to, t);
  return before + behind > 0.0 ? glm::mix(s.from, s.to, before / (before + behind)) : s.from;
}

std::optional<Vec3> common_place(const Vec3& p, const Corners& t) {
  return orientation_sign(t, p) == 0 ? place_in_plane({p, p}, t) : std::nullopt;
}

using SidesOfCorners = std::array<int, 3>;

SidesOfCorners orientation_signs(const Corners& plane, const Corners& t) {
  return {orientation_sign(plane, t[0]), orientation_sign(plane, t[1]), orientation_sign(plane, t[2])};
}

bool are_one(const SidesOfCorners& s) { return s[0] * s[1] > 0 && s[1] * s[2] > 0; }

/// Returns the first point where an edge of `a` pierces `b`. `sides` are the sides of `b` where the corners of `a` are.
std::optional<Vec3> first_place_along_edges(const Corners& a, const SidesOfCorners& sides, const Corners& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (const auto place = common_place(triangle_edge(a, k), {sides[k], sides[(k + 1) % 3]}, b)) return place;
  }
  return std::nullopt;
}

/// Returns a common point on the edge of `a` opposite the shared corner 0. Seen from this corner, the common points end
/// at the opposite edge of one of the triangles. The edge's ends are on these sides of `b`. If `a` has no area, its
/// corner may lie on the edge, and only the ends are tested.
std::optional<Vec3> place_opposite(const Corners& a, const SidesOfEnds& sides, const Corners& b) {
  if (!is_without_area(a)) return common_place({a[1], a[2]}, sides, b);
  for (const Vec3& end : {a[1], a[2]}) {
    if (end != a[0] && common_place(end, b)) return end;
  }
  return std::nullopt;
}

/// Returns whether a plane at right angles to the axis certainly separates these points: by far more than rounding,
/// which is some 1e-15 of their distances from the plane's origin. This test is cheap and separates most neighbours,
/// also in one plane, where exact signs are slow.
bool are_far_apart(const Vec3& origin, const Vec3& axis, std::span<const Vec3> before, std::span<const Vec3> behind) {
  constexpr double far = 1e-6;
  // Products below this lose digits.
  constexpr double smallest = 1e-200;
  const auto is_in_front = [&](const Vec3& p, double side) {
    const double far_off = far * glm::length(axis) * glm::distance(p, origin);
    return side * glm::dot(axis, p - origin) > std::max(far_off, smallest);
  };
  const auto is_before = [&](const Vec3& p) { return is_in_front(p, 1.0); };
  const auto is_behind = [&](const Vec3& p) { return is_in_front(p, -1.0); };
  return std::ranges::all_of(before, is_before) && std::ranges::all_of(behind, is_behind);
}

Vec3 centroid(const Corners& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// Returns a direction from corner 0 between both sides.
Vec3 inwards(const Corners& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  return glm::length(v) * u + glm::length(u) * v;
}

/// Requires triangles that share their first two corners.
bool reaches_beyond_edge(const Corners& a, const Corners& b) {
  return !segments_meet({a[2], a[2]}, triangle_edge(a, 0)) && common_place(a[2], b);
}

}  // namespace

std::optional<Vec3> crossing_place(const Corners& a, const Corners& b) {
  const Vec3 from = centroid(b), to = centroid(a);
  if (are_far_apart(0.5 * (from + to), to - from, a, b)) return std::nullopt;
  const SidesOfCorners of_b = orientation_signs(a, b);
  if (are_one(of_b)) return std::nullopt;
  const SidesOfCorners of_a = orientation_signs(b, a);
  if (are_one(of_a)) return std::nullopt;
  const std::optional<Vec3> place = first_place_along_edges(a, of_a, b);
  return place ? place : first_place_along_edges(b, of_b, a);
}

std::optional<Vec3> crossing_place_beside_vertex(const Corners& a, const Corners& b) {
  const Vec3 axis = glm::normalize(inwards(a)) - glm::normalize(inwards(b));
  if (are_far_apart(a[0], axis, std::span(a).subspan(1), std::span(b).subspan(1))) return std::nullopt;
  const SidesOfEnds of_b = orientation_signs(a, b[1], b[2]);
  if (of_b.are_one()) return std::nullopt;
  // Triangles in one plane have no sides, which exact signs are slow to find out. A triangle `a` without area needs
  // none.
  const SidesOfEnds of_a = of_b.are_none() ? SidesOfEnds{0, 0} : orientation_signs(b, a[1], a[2]);
  if (of_a.are_one()) return std::nullopt;
  const std::optional<Vec3> place = place_opposite(a, of_a, b);
  return place ? place : place_opposite(b, of_b, a);
}

std::optional<Vec3> crossing_place_beside_edge(const Corners& a, const Corners& b) {
  const Vec3 edge = a[1] - a[0], side = a[2] - a[0];
  const Vec3 across = side - glm::dot(side, edge) / glm::dot(edge, edge) * edge;
  if (are_far_apart(a[0], across, std::span(a).last(1), std::span(b).last(1))) return std::nullopt;
  if (orientation(a[0], a[1], a[2], b[2]) != 0) return std::nullopt;
  bool is_folded = false;
  for (int axis = 0; axis < 3; ++axis) {
    is_folded =
        is_folded || orientation_without(axis, a[0], a[1], a[2]) * orientation_without(axis, b[0], b[1], b[2]) > 0;
  }
  // Triangles without area are segments along the line of the edge.
  if (is_folded || reaches_beyond_edge(a, b) || reaches_beyond_edge(b, a)) return 0.5 * (a[0] + a[1]);
  return std::nullopt;
}

}  // namespace taut::app
