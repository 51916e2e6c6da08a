#include "sim/contact/triangle_pair.hpp"

#include "sim/mesh/mesh.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Smallest height in m above the common edge of a triangle that can fold onto its neighbour.
constexpr double min_fold_height_m = 1e-9;

double clamped_fraction(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

double point_segment_distance_m(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 edge = to - from;
  return glm::distance(p, from + clamped_fraction(glm::dot(p - from, edge), glm::dot(edge, edge)) * edge);
}

/// Returns the distance between inner points of two segments; infinite if an end is nearer.
double inner_distance_m(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, r = a - c;
  const Vec3 normal = glm::cross(u, v);
  const double square = glm::dot(normal, normal);
  const double at_u = glm::dot(glm::cross(v, r), normal);
  const double at_v = glm::dot(glm::cross(u, r), normal);
  if (!(square > 0.0 && at_u >= 0.0 && at_u <= square && at_v >= 0.0 && at_v <= square)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs(glm::dot(r, normal)) / std::sqrt(square);
}

/// Returns the side of the plane through a, b and c that d is on: 1, -1, or 0 if rounding would decide.
int plane_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double rounding = 1e-15;
  const Vec3 u = b - a, v = c - a, w = d - a;
  double volume = 0.0, size = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const double plus = u[l] * v[m], minus = u[m] * v[l];
    volume += (plus - minus) * w[k];
    size += (std::abs(plus) + std::abs(minus)) * std::abs(w[k]);
  }
  return volume > rounding * size ? 1 : (volume < -rounding * size ? -1 : 0);
}

/// Returns whether the segment certainly passes through the inside of the triangle. Cases that rounding would decide
/// touch a corner, an edge or the face instead.
bool pierces(const Vec3& from, const Vec3& to, const Corners& t) {
  if (plane_side(t[0], t[1], t[2], from) * plane_side(t[0], t[1], t[2], to) >= 0) return false;
  const int first = plane_side(from, to, t[0], t[1]);
  return first != 0 && plane_side(from, to, t[1], t[2]) == first && plane_side(from, to, t[2], t[0]) == first;
}

/// Returns whether a plane at right angles to the axis separates the triangles by more than the reach.
bool are_separated(const Vec3& axis, const Corners& a, const Corners& b, double reach_m) {
  assert(reach_m >= 0.0);
  const std::array<double, 3> of_a = {glm::dot(axis, a[0]), glm::dot(axis, a[1]), glm::dot(axis, a[2])};
  const std::array<double, 3> of_b = {glm::dot(axis, b[0]), glm::dot(axis, b[1]), glm::dot(axis, b[2])};
  const auto [low_a, high_a] = std::minmax({of_a[0], of_a[1], of_a[2]});
  const auto [low_b, high_b] = std::minmax({of_b[0], of_b[1], of_b[2]});
  const double apart = std::max(low_a - high_b, low_b - high_a);
  return apart > 0.0 && apart * apart > reach_m * reach_m * glm::dot(axis, axis);
}

/// Returns whether a plane through a face, or upright on it through an edge, separates the triangles by the reach.
bool are_separated(const Corners& a, const Corners& b, double reach_m) {
  for (const Corners* t : {&a, &b}) {
    const Vec3 normal = glm::cross((*t)[1] - (*t)[0], (*t)[2] - (*t)[0]);
    if (are_separated(normal, a, b, reach_m)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (are_separated(glm::cross((*t)[(k + 1) % 3] - (*t)[k], normal), a, b, reach_m)) return true;
    }
  }
  return false;
}

/// Moves shared corners to the front of both triangles, in the same order. Returns their number.
std::size_t bring_shared_to_front(Triangle& s, Triangle& t) {
  assert(s[0] != s[1] && s[1] != s[2] && s[2] != s[0]);
  assert(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (s[i] == t[j]) {
        std::swap(s[shared], s[i]);
        std::swap(t[shared], t[j]);
        ++shared;
        break;
      }
    }
  }
  return shared;
}

/// Measures triangles whose first `shared` corners, 0 or 1, are identical.
TrianglePairMeasure measure_with(std::size_t shared, const Corners& a, const Corners& b) {
  assert(shared <= 3);
  double distance_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = shared; k < 3; ++k) {
    distance_m = std::min({distance_m, point_triangle_distance_m(a[k], b), point_triangle_distance_m(b[k], a)});
  }
  bool is_pierced = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const bool is_free = k >= shared && l >= shared;
    is_pierced = is_pierced || (is_free && (pierces(a[k], a[l], b) || pierces(b[k], b[l], a)));
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t n = (m + 1) % 3;
      if (is_free || (m >= shared && n >= shared)) {
        distance_m = std::min(distance_m, inner_distance_m(a[k], a[l], b[m], b[n]));
      }
    }
  }
  return {distance_m, is_pierced};
}

/// Measures triangles whose first two corners are identical.
TrianglePairMeasure measure_beside_edge(const Corners& a, const Corners& b) {
  const double distance_m =
      std::min({point_triangle_distance_m(a[2], b), point_triangle_distance_m(b[2], a),
                inner_distance_m(a[0], a[2], b[1], b[2]), inner_distance_m(a[1], a[2], b[0], b[2])});
  return {distance_m, false};
}

/// Returns whether one of the triangles has collapsed to the common edge.
bool is_flat_beside_edge(const Corners& a, const Corners& b) {
  return std::min(point_segment_distance_m(a[2], a[0], a[1]), point_segment_distance_m(b[2], a[0], a[1])) <
         min_fold_height_m;
}

/// Returns whether a plane through the common first corner separates the other corners, which are further from it.
bool lie_apart(const Corners& a, const Corners& b, double distance_m) {
  const Vec3 u = a[1] - a[0], v = a[2] - a[0], x = b[1] - a[0], y = b[2] - a[0];
  const Vec3 axis = (u + v) - (x + y);
  const double min_offset = distance_m * glm::length(axis);
  return glm::dot(axis, u) > min_offset && glm::dot(axis, v) > min_offset && glm::dot(axis, x) < -min_offset &&
         glm::dot(axis, y) < -min_offset;
}

/// Returns whether `b` lies on one side of the plane of `a`; both share their first corner.
bool has_on_one_side(const Corners& a, const Corners& b) {
  const Vec3 normal = glm::cross(a[1] - a[0], a[2] - a[0]);
  const double min_offset = touching_m * glm::length(normal);
  const double x = glm::dot(normal, b[1] - a[0]), y = glm::dot(normal, b[2] - a[0]);
  return (x > min_offset && y > min_offset) || (x < -min_offset && y < -min_offset);
}

/// Returns whether triangles with common first two corners lie on different sides of a plane through these.
bool are_unfolded(const Corners& a, const Corners& b) {
  const Vec3 edge = a[1] - a[0], normal = glm::cross(edge, a[2] - a[0]);
  return glm::dot(glm::cross(edge, b[2] - a[0]), normal) < 0.0;
}

}  // namespace

// The smaller of the distances from the edges and, above the face, from the face; exact in thin triangles too.
double point_triangle_distance_m(const Vec3& p, const Corners& t) {
  double distance_m = std::min({point_segment_distance_m(p, t[0], t[1]), point_segment_distance_m(p, t[1], t[2]),
                                point_segment_distance_m(p, t[2], t[0])});
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(normal, normal);
  const double v = glm::dot(glm::cross(p - t[0], t[2] - t[0]), normal);
  const double w = glm::dot(glm::cross(t[1] - t[0], p - t[0]), normal);
  if (square > 0.0 && v >= 0.0 && w >= 0.0 && v + w <= square) {
    distance_m = std::min(distance_m, std::abs(glm::dot(p - t[0], normal)) / std::sqrt(square));
  }
  return distance_m;
}

TrianglePairMeasure measure_pair(const Triangle& s, const Triangle& t, std::span<const Vec3> s_positions_m,
                                 std::span<const Vec3> t_positions_m, double reach_m) {
  assert(are_below(std::span(&s, 1), s_positions_m.size()));
  assert(are_below(std::span(&t, 1), t_positions_m.size()));
  assert(reach_m >= 0.0);
  // Positions relative to one corner, so that rounding is proportional to distances.
  const Vec3 origin_m = s_positions_m[s[0]];
  Corners a = corner_positions(s, s_positions_m), b = corner_positions(t, t_positions_m);
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] -= origin_m;
    b[k] -= origin_m;
  }
  if (are_separated(a, b, reach_m)) return {std::numeric_limits<double>::infinity(), false};
  return measure_with(0, a, b);
}

TrianglePairMeasure measure_neighbours(Triangle s, Triangle t, std::span<const Vec3> positions_m) {
  assert(are_below(std::array{s, t}, positions_m.size()));
  const std::size_t shared = bring_shared_to_front(s, t);
  const Corners a = corner_positions(s, positions_m), b = corner_positions(t, positions_m);
  return shared == 1 ? measure_with(1, a, b) : measure_beside_edge(a, b);
}

bool corner_neighbours_lie_apart(Triangle s, Triangle t, std::span<const Vec3> positions_m, double distance_m) {
  assert(are_below(std::array{s, t}, positions_m.size()));
  assert(distance_m >= 0.0);
  return bring_shared_to_front(s, t) == 1 &&
         lie_apart(corner_positions(s, positions_m), corner_positions(t, positions_m), distance_m);
}

bool neighbours_cross(Triangle s, Triangle t, std::span<const Vec3> positions_m) {
  assert(are_below(std::array{s, t}, positions_m.size()));
  const std::size_t shared = bring_shared_to_front(s, t);
  const Corners a = corner_positions(s, positions_m), b = corner_positions(t, positions_m);
  return shared == 1 ? !lie_apart(a, b, touching_m) && !has_on_one_side(a, b) && !has_on_one_side(b, a) &&
                           measure_with(1, a, b).is_crossing()
                     : !are_unfolded(a, b) && !is_flat_beside_edge(a, b) && measure_beside_edge(a, b).is_crossing();
}

}  // namespace taut::sim
