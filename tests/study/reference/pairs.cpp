#include <cmath>

#include "tests/study/reference/incremental_potential.hpp"

// Distances of pairs and collision-free steps.

namespace reference {
namespace {

Point compute_distance_vector(const Eigen::Vector4d& weights, const std::array<Point, 4>& x) {
  return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
}

void measure(const std::array<Point, 4>& x, Closest& closest) {
  closest.squared_m2 = compute_distance_vector(closest.weights, x).squaredNorm();
}

/// Returns the nearest points of vertex p and the edge from a to b.
Closest point_to_edge(const std::array<Point, 4>& x, int p, int a, int b) {
  const Point along = x[b] - x[a];
  const double at = along.dot(x[p] - x[a]) / along.squaredNorm();
  Closest closest;
  closest.weights[p] = 1.0;
  if (at > 0.0 && at < 1.0) {
    closest.free_count = 1;
    closest.free[0].setZero();
    closest.free[0][a] = 1.0;
    closest.free[0][b] = -1.0;
  }
  const double kept = std::clamp(at, 0.0, 1.0);
  closest.weights[a] = kept - 1.0;
  closest.weights[b] = -kept;
  measure(x, closest);
  return closest;
}

/// Minimum of |r + s u + t v| with both parameters free.
struct Inside {
  double s, t;
  bool is_regular;
};

Inside solve(const Point& r, const Point& u, const Point& v) {
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  return {(uv * v.dot(r) - vv * u.dot(r)) / determinant, (uv * u.dot(r) - uu * v.dot(r)) / determinant,
          determinant > 1e-12 * uu * vv};
}

Closest find_nearest(std::initializer_list<Closest> all) {
  return *std::min_element(all.begin(), all.end(),
                           [](const Closest& a, const Closest& b) { return a.squared_m2 < b.squared_m2; });
}

Closest inside(const std::array<Point, 4>& x, const Eigen::Vector4d& weights, const Eigen::Vector4d& s,
               const Eigen::Vector4d& t) {
  Closest closest{weights, {s, t}, 2, 0.0};
  measure(x, closest);
  return closest;
}

Closest of_point_and_triangle(const std::array<Point, 4>& x) {
  const Inside in = solve(x[0] - x[1], x[1] - x[2], x[1] - x[3]);
  if (in.is_regular && in.s > 0.0 && in.t > 0.0 && in.s + in.t < 1.0) {
    return inside(x, {1.0, in.s + in.t - 1.0, -in.s, -in.t}, {0.0, 1.0, -1.0, 0.0}, {0.0, 1.0, 0.0, -1.0});
  }
  return find_nearest({point_to_edge(x, 0, 1, 2), point_to_edge(x, 0, 2, 3), point_to_edge(x, 0, 3, 1)});
}

Closest of_edges(const std::array<Point, 4>& x) {
  const Inside in = solve(x[0] - x[2], x[1] - x[0], x[2] - x[3]);
  if (in.is_regular && in.s > 0.0 && in.s < 1.0 && in.t > 0.0 && in.t < 1.0) {
    return inside(x, {1.0 - in.s, in.s, in.t - 1.0, -in.t}, {-1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, -1.0});
  }
  return find_nearest(
      {point_to_edge(x, 0, 2, 3), point_to_edge(x, 1, 2, 3), point_to_edge(x, 2, 0, 1), point_to_edge(x, 3, 0, 1)});
}

}  // namespace

Closest find_closest(const Pair& pair, const std::array<Point, 4>& x) {
  return pair.is_of_edges ? of_edges(x) : of_point_and_triangle(x);
}

double step_that_keeps_apart(const Pair& pair, std::array<Point, 4> x, std::array<Point, 4> by) {
  constexpr double kept_part = 0.1;
  const Point mean = 0.25 * (by[0] + by[1] + by[2] + by[3]);
  for (Point& p : by) p -= mean;
  const std::array<double, 4> lengths = {by[0].norm(), by[1].norm(), by[2].norm(), by[3].norm()};
  const double closing = pair.is_of_edges ? std::max(lengths[0], lengths[1]) + std::max(lengths[2], lengths[3])
                                          : lengths[0] + std::max({lengths[1], lengths[2], lengths[3]});
  const auto gap = [&] { return std::sqrt(find_closest(pair, x).squared_m2) - pair.offset_m; };
  const double first = gap();
  double done = 0.0;
  for (double left = first; closing > 0.0;) {
    const double step = (1.0 - kept_part) * left / closing;
    for (std::size_t i = 0; i < 4; ++i) x[i] += step * by[i];
    left = gap();
    if (left < kept_part * first && done > 0.0) return done;
    done += step;
    if (done >= 1.0) return 1.0;
    if (left < kept_part * first) return done;
  }
  return 1.0;
}

}  // namespace reference
