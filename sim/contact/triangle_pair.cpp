#include "sim/contact/triangle_pair.hpp"

namespace taut::sim {
namespace {

/// A triangle that is lower above an edge, in m, does not fold onto what is on the other side of it.
constexpr double least_height_m = 1e-9;

double part_of(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

double point_segment_distance_m(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 edge = to - from;
  return glm::distance(p, from + part_of(glm::dot(p - from, edge), glm::dot(edge, edge)) * edge);
}

/// Between inner points of two segments; infinite where an end is nearer.
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

/// Which side of the plane through a, b and c the point d is on: 1, -1, or 0 where rounding would decide.
int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
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

/// Whether the segment goes through the inside of the triangle for certain. Where rounding would decide, it comes as
/// near to a corner, an edge or with an end to the face as rounding goes: then the two touch.
bool pierces(const Vec3& from, const Vec3& to, const Corners& t) {
  if (side_of(t[0], t[1], t[2], from) * side_of(t[0], t[1], t[2], to) >= 0) return false;
  const int first = side_of(from, to, t[0], t[1]);
  return first != 0 && side_of(from, to, t[1], t[2]) == first && side_of(from, to, t[2], t[0]) == first;
}

/// Whether the triangles lie on different sides of a plane at right angles to the axis, further apart than the reach.
bool are_parted(const Vec3& axis, const Corners& a, const Corners& b, double reach_m) {
  const std::array<double, 3> of_a = {glm::dot(axis, a[0]), glm::dot(axis, a[1]), glm::dot(axis, a[2])};
  const std::array<double, 3> of_b = {glm::dot(axis, b[0]), glm::dot(axis, b[1]), glm::dot(axis, b[2])};
  const auto [low_a, high_a] = std::minmax({of_a[0], of_a[1], of_a[2]});
  const auto [low_b, high_b] = std::minmax({of_b[0], of_b[1], of_b[2]});
  const double apart = std::max(low_a - high_b, low_b - high_a);
  return apart > 0.0 && apart * apart > reach_m * reach_m * glm::dot(axis, axis);
}

/// Whether one of the planes through a face, or upright on it through an edge, parts the triangles by the reach.
bool are_parted(const Corners& a, const Corners& b, double reach_m) {
  for (const Corners* t : {&a, &b}) {
    const Vec3 normal = glm::cross((*t)[1] - (*t)[0], (*t)[2] - (*t)[0]);
    if (are_parted(normal, a, b, reach_m)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (are_parted(glm::cross((*t)[(k + 1) % 3] - (*t)[k], normal), a, b, reach_m)) return true;
    }
  }
  return false;
}

/// Turns the corners of both so that those that are shared come first, in the same order. Returns how many.
std::size_t bring_shared_to_front(Triangle& s, Triangle& t) {
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

/// Of triangles whose first `shared` corners, none or one, are one and the same.
TrianglePairMeasure measure_with(std::size_t shared, const Corners& a, const Corners& b) {
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

/// Of triangles whose first two corners are the same.
TrianglePairMeasure measure_beside_edge(const Corners& a, const Corners& b) {
  const double distance_m =
      std::min({point_triangle_distance_m(a[2], b), point_triangle_distance_m(b[2], a),
                inner_distance_m(a[0], a[2], b[1], b[2]), inner_distance_m(a[1], a[2], b[0], b[2])});
  return {distance_m, false};
}

/// Whether one of them is no more than that edge.
bool is_flat_beside_edge(const Corners& a, const Corners& b) {
  return std::min(point_segment_distance_m(a[2], a[0], a[1]), point_segment_distance_m(b[2], a[0], a[1])) <
         least_height_m;
}

/// Whether triangles that share their first corner lie on different sides of a plane through it.
bool lie_apart(const Corners& a, const Corners& b) {
  const Vec3 u = a[1] - a[0], v = a[2] - a[0], x = b[1] - a[0], y = b[2] - a[0];
  const Vec3 axis = (u + v) - (x + y);
  const double least = touching_m * glm::length(axis);
  return glm::dot(axis, u) > least && glm::dot(axis, v) > least && glm::dot(axis, x) < -least &&
         glm::dot(axis, y) < -least;
}

/// Whether the plane of the one, through their common first corner, has the other on one side.
bool has_on_one_side(const Corners& a, const Corners& b) {
  const Vec3 normal = glm::cross(a[1] - a[0], a[2] - a[0]);
  const double least = touching_m * glm::length(normal);
  const double x = glm::dot(normal, b[1] - a[0]), y = glm::dot(normal, b[2] - a[0]);
  return (x > least && y > least) || (x < -least && y < -least);
}

/// Whether triangles that share their first two corners lie on different sides of a plane through these.
bool unfold(const Corners& a, const Corners& b) {
  const Vec3 edge = a[1] - a[0], normal = glm::cross(edge, a[2] - a[0]);
  return glm::dot(glm::cross(edge, b[2] - a[0]), normal) < 0.0;
}

Corners corners_in(const Triangle& t, std::span<const Vec3> positions_m) {
  return {positions_m[t[0]], positions_m[t[1]], positions_m[t[2]]};
}

}  // namespace

// The smaller of the distances from the face, where the point is above it, and from the edges: right in thin
// triangles too.
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
  // From the one on, so that rounding is that of their distance.
  const Vec3 origin_m = s_positions_m[s[0]];
  Corners a = corners_in(s, s_positions_m), b = corners_in(t, t_positions_m);
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] -= origin_m;
    b[k] -= origin_m;
  }
  if (are_parted(a, b, reach_m)) return {std::numeric_limits<double>::infinity(), false};
  return measure_with(0, a, b);
}

TrianglePairMeasure measure_neighbours(Triangle s, Triangle t, std::span<const Vec3> positions_m) {
  const std::size_t shared = bring_shared_to_front(s, t);
  const Corners a = corners_in(s, positions_m), b = corners_in(t, positions_m);
  return shared == 1 ? measure_with(1, a, b) : measure_beside_edge(a, b);
}

bool neighbours_cross(Triangle s, Triangle t, std::span<const Vec3> positions_m) {
  const std::size_t shared = bring_shared_to_front(s, t);
  const Corners a = corners_in(s, positions_m), b = corners_in(t, positions_m);
  return shared == 1 ? !lie_apart(a, b) && !has_on_one_side(a, b) && !has_on_one_side(b, a) &&
                           measure_with(1, a, b).is_crossing()
                     : !unfold(a, b) && !is_flat_beside_edge(a, b) && measure_beside_edge(a, b).is_crossing();
}

}  // namespace taut::sim
