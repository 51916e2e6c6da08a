#include "tailor/flat/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

// The C interface: Qhull's C++ headers are not valid C++20.
extern "C" {
#include <libqhull_r/libqhull_r.h>
#include <libqhull_r/mem_r.h>
#include <libqhull_r/poly_r.h>
}

namespace taut::tailor {
namespace {

// Three neighbouring points of a straight border make a facet of no area; no real triangle is this small.
constexpr double smallest_doubled_area_m2 = 1e-9;

sim::Triangle counter_clockwise(std::span<const Vec2> points, sim::Triangle t) {
  if (doubled_area(points[t[0]], points[t[1]], points[t[2]]) < 0.0) {
    std::swap(t[1], t[2]);
  }
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

bool is_in_cloth(std::span<const Vec2> points, std::span<const Vec2> outline, const sim::Triangle& t) {
  const Vec2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
  return doubled_area(a, b, c) > smallest_doubled_area_m2 && is_inside(outline, (a + b + c) / 3.0);
}

/// A disc of triangles with these corners has exactly this many, and its area.
void check_complete(std::span<const Vec2> points, std::size_t outline_count,
                    const std::vector<sim::Triangle>& triangles) {
  const std::size_t expected = 2 * (points.size() - outline_count) + outline_count - 2;
  double area_m2 = 0.0;
  for (const sim::Triangle& t : triangles) {
    area_m2 += 0.5 * doubled_area(points[t[0]], points[t[1]], points[t[2]]);
  }
  const double outline_area_m2 = polygon_area(points.first(outline_count));
  if (triangles.size() != expected || std::abs(area_m2 - outline_area_m2) > 1e-9 * outline_area_m2) {
    throw std::runtime_error(
        "the triangulation of a piece does not fill its outline: " + std::to_string(triangles.size()) +
        " triangles, expected " + std::to_string(expected));
  }
}

/// Qhull's memory, released in any case.
class Qhull {
 public:
  Qhull() { qh_zero(&qh_, stderr); }
  ~Qhull() {
    int long_blocks = 0;
    int long_bytes = 0;
    qh_freeqhull(&qh_, !qh_ALL);
    qh_memfreeshort(&qh_, &long_blocks, &long_bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// The triangles of the lower hull, which are the Delaunay triangles, in no particular order.
  std::vector<sim::Triangle> delaunay(std::vector<double>& coordinates) {
    // d: Delaunay; Qbb: scaled for precision; Qt: triangles only; Qz: a point at infinity, for rows of
    // points.
    char command[] = "qhull d Qbb Qt Qz";
    const int count = static_cast<int>(coordinates.size() / 2);
    if (qh_new_qhull(&qh_, 2, count, coordinates.data(), False, command, nullptr, stderr) != 0) {
      throw std::runtime_error("Qhull could not triangulate a piece of " + std::to_string(count) + " points");
    }
    std::vector<sim::Triangle> triangles;
    for (const facetT* facet = qh_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      if (!facet->upperdelaunay) {
        triangles.push_back(corners_of(*facet));
      }
    }
    return triangles;
  }

 private:
  sim::Triangle corners_of(const facetT& facet) {
    sim::Triangle t{};
    for (int corner = 0; corner < 3; ++corner) {
      const auto* vertex = static_cast<const vertexT*>(facet.vertices->e[corner].p);
      t[static_cast<std::size_t>(corner)] = static_cast<sim::Index>(qh_pointid(&qh_, vertex->point));
    }
    return t;
  }

  qhT qh_{};
};

}  // namespace

std::vector<sim::Triangle> triangulate(std::span<const Vec2> points, std::size_t outline_count) {
  std::vector<double> coordinates;
  for (const Vec2& p : points) {
    coordinates.insert(coordinates.end(), {p.x, p.y});
  }
  std::vector<sim::Triangle> triangles;
  for (const sim::Triangle& found : Qhull().delaunay(coordinates)) {
    const sim::Triangle t = counter_clockwise(points, found);
    if (is_in_cloth(points, points.first(outline_count), t)) {
      triangles.push_back(t);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  check_complete(points, outline_count, triangles);
  return triangles;
}

}  // namespace taut::tailor
