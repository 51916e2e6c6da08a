#include "app/figures/experiments/fabric_disc.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <random>

#include "sim/mesh/elementary.hpp"

namespace taut::app {
namespace {

using Points = std::vector<glm::dvec2>;

/// How far a point may be from its place in a lattice, as a fraction of the edges.
constexpr double scatter = 0.25;
/// How near to a circle no point of the lattice is, as a fraction of the edges.
constexpr double clearance = 0.65;
/// Of the triangle around all, in radii of the disc: so far that it bends no circle through the border.
constexpr double far_away = 50.0;
/// Points of a circle are joined as if each were this far beside it, as a fraction of the edges: of more than
/// three on one circle none is in it.
constexpr double aside = 1e-3;

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// In [low, high), with the same bits everywhere.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 bits_;
};

void add_circle(double radius_m, double edge_m, Random& random, Points& points) {
  const double count = std::round(2.0 * std::numbers::pi * radius_m / edge_m);
  const double first = random.between(0.0, 1.0);
  for (double k = 0.0; k < count; k += 1.0) {
    const double turns = (k + first) / count;
    points.push_back({radius_m * sim::cosine_of_turns(turns), radius_m * sim::sine_of_turns(turns)});
  }
}

/// Even triangles, turned and shaken.
void add_lattice(double inner_m, double radius_m, double edge_m, Random& random, Points& points) {
  const double turns = random.between(0.0, 1.0);
  const glm::dvec2 along{sim::cosine_of_turns(turns), sim::sine_of_turns(turns)};
  const glm::dvec2 across{-along.y, along.x};
  const int most = static_cast<int>(std::ceil(1.2 * radius_m / edge_m)) + 1;
  for (int row = -most; row <= most; ++row) {
    for (int column = -most; column <= most; ++column) {
      const double x = column + (row % 2 == 0 ? 0.0 : 0.5) + random.between(-scatter, scatter);
      const double y = 0.8660254037844386 * row + random.between(-scatter, scatter);
      const glm::dvec2 point = edge_m * (x * along + y * across);
      const double from_middle_m = glm::length(point);
      if (from_middle_m < radius_m - clearance * edge_m &&
          std::abs(from_middle_m - inner_m) > clearance * edge_m) {
        points.push_back(point);
      }
    }
  }
}

double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether p lies in the circle through a, b and c, which turn counter-clockwise.
bool is_in_circle(const glm::dvec2& p, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  a -= p;
  b -= p;
  c -= p;
  return glm::dot(a, a) * (b.x * c.y - b.y * c.x) - glm::dot(b, b) * (a.x * c.y - a.y * c.x) +
             glm::dot(c, c) * (a.x * b.y - a.y * b.x) >
         0.0;
}

/// Puts a point into the triangles: those around whose corners goes a circle that it lies in make way for a
/// fan.
void insert(const Points& points, sim::Index p, std::vector<sim::Triangle>& triangles) {
  std::map<sim::Edge, int> edges;
  std::vector<sim::Triangle> kept;
  for (const sim::Triangle& t : triangles) {
    if (!is_in_circle(points[p], points[t[0]], points[t[1]], points[t[2]])) {
      kept.push_back(t);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge[1], edge[0]})) {
      kept.push_back({edge[0], edge[1], p});
    }
  }
  triangles = std::move(kept);
}

std::vector<sim::Triangle> triangulated(Points points, double radius_m) {
  const auto count = static_cast<sim::Index>(points.size());
  const double far_m = far_away * radius_m;
  points.insert(points.end(), {{-far_m, -far_m}, {far_m, -far_m}, {0.0, far_m}});
  std::vector<sim::Triangle> triangles = {{count, count + 1, count + 2}};
  for (sim::Index p = 0; p < count; ++p) {
    insert(points, p, triangles);
  }
  std::erase_if(triangles, [&](const sim::Triangle& t) {
    return t[0] >= count || t[1] >= count || t[2] >= count ||
           doubled_area(points[t[0]], points[t[1]], points[t[2]]) < 1e-4 * radius_m * radius_m / count;
  });
  return triangles;
}

}  // namespace

sim::Mesh make_disc(double inner_radius_m, double radius_m, const DiscMesh& mesh) {
  Random random(mesh.seed);
  Points points;
  add_circle(inner_radius_m, mesh.edge_m, random, points);
  add_circle(radius_m, mesh.edge_m, random, points);
  add_lattice(inner_radius_m, radius_m, mesh.edge_m, random, points);
  sim::Mesh disc;
  for (const glm::dvec2& p : points) {
    disc.positions.push_back({p.x, 0.0, -p.y});
  }
  for (glm::dvec2& p : points) {
    // Compilers choose the order of a call's arguments.
    const double up = random.between(-aside, aside);
    const double right = random.between(-aside, aside);
    p += mesh.edge_m * glm::dvec2(right, up);
  }
  disc.triangles = triangulated(std::move(points), radius_m);
  return disc;
}

}  // namespace taut::app
