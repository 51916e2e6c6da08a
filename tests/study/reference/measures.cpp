#include "tests/study/reference/measures.hpp"

#include <cmath>
#include <set>

namespace reference {
namespace {

/// Computes the largest distance and the sum of squared distances of all vertices from the other surface.
void compare(const Surface& from, const Surface& to, double& max_distance_m, double& squares_m2) {
  for (const Point& p : from.points_m) {
    double min_distance_m2 = std::numeric_limits<double>::infinity();
    for (const Corners& t : to.triangles) {
      const std::array<Point, 4> points = {p, to.points_m[t[0]], to.points_m[t[1]], to.points_m[t[2]]};
      min_distance_m2 = std::min(min_distance_m2, find_closest({}, points).squared_m2);
    }
    max_distance_m = std::max(max_distance_m, std::sqrt(min_distance_m2));
    squares_m2 += min_distance_m2;
  }
}

/// Returns true if the point is within the triangle in the view along y.
bool is_below(const std::array<Point, 3>& corners, double x, double z) {
  const auto side = [&](const Point& a, const Point& b) {
    return (b.x() - a.x()) * (z - a.z()) - (b.z() - a.z()) * (x - a.x());
  };
  const double p = side(corners[0], corners[1]), q = side(corners[1], corners[2]), r = side(corners[2], corners[0]);
  return (p >= 0.0 && q >= 0.0 && r >= 0.0) || (p <= 0.0 && q <= 0.0 && r <= 0.0);
}

}  // namespace

Difference difference(const Surface& one, const Surface& other) {
  Difference result;
  double squares_m2 = 0.0, moved_m2 = 0.0;
  compare(one, other, result.hausdorff_m, squares_m2);
  compare(other, one, result.hausdorff_m, squares_m2);
  for (std::size_t v = 0; v < one.points_m.size(); ++v) moved_m2 += (one.points_m[v] - other.points_m[v]).squaredNorm();
  const auto count = static_cast<double>(one.points_m.size());
  result.mean_m = std::sqrt(squares_m2 / (2.0 * count));
  result.vertices_m = std::sqrt(moved_m2 / count);
  return result;
}

Drape measure_drape(const Surface& surface, const std::vector<double>& masses_kg) {
  constexpr double cell_m = 1e-3;
  Drape drape{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  double sum_kg = 0.0;
  for (std::size_t v = 0; v < surface.points_m.size(); ++v) {
    drape.min_height_m = std::min(drape.min_height_m, surface.points_m[v].y());
    drape.mean_m += masses_kg[v] * surface.points_m[v].y();
    sum_kg += masses_kg[v];
  }
  drape.mean_m /= sum_kg;
  std::set<std::pair<int, int>> dark;
  for (const Corners& t : surface.triangles) {
    const std::array<Point, 3> p = {surface.points_m[t[0]], surface.points_m[t[1]], surface.points_m[t[2]]};
    const Point low = p[0].cwiseMin(p[1]).cwiseMin(p[2]) / cell_m, high = p[0].cwiseMax(p[1]).cwiseMax(p[2]) / cell_m;
    for (int i = static_cast<int>(std::floor(low.x())); i <= static_cast<int>(std::ceil(high.x())); ++i) {
      for (int j = static_cast<int>(std::floor(low.z())); j <= static_cast<int>(std::ceil(high.z())); ++j) {
        if (is_below(p, cell_m * i, cell_m * j)) dark.emplace(i, j);
      }
    }
  }
  drape.shadow_m2 = cell_m * cell_m * static_cast<double>(dark.size());
  return drape;
}

Surface make_surface(const Cloth& cloth, const Vector& x) {
  Surface surface{{}, cloth.triangles};
  for (int v = 0; v < static_cast<int>(cloth.rest_m.size()); ++v) {
    if (v != cloth.ball) surface.points_m.push_back(at(x, v));
  }
  return surface;
}

}  // namespace reference
