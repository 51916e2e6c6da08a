#include "app/fitting/following.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "app/fitting/surface_tree.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

/// How much further away a triangle may be that faces the same way.
constexpr double preferred = 2.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

Vec3 unit(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3(0.0);
}

/// The weights of the corners at the point of the triangle that is nearest to p.
std::array<double, 3> nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const auto on_edge = [&p](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double squared = glm::dot(way, way);
    return squared > 0.0 ? std::clamp(glm::dot(p - from, way) / squared, 0.0, 1.0) : 0.0;
  };
  const Vec3 normal = glm::cross(ab, ac);
  const double squared = glm::dot(normal, normal);
  if (squared > 0.0) {
    const double v = glm::dot(glm::cross(p - a, ac), normal) / squared;
    const double w = glm::dot(glm::cross(ab, p - a), normal) / squared;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
      return {1.0 - v - w, v, w};
    }
  }
  const double s = on_edge(a, b), t = on_edge(b, c), u = on_edge(c, a);
  const std::array<std::array<double, 3>, 3> edges = {{{1.0 - s, s, 0.0}, {0.0, 1.0 - t, t}, {u, 0.0, 1.0 - u}}};
  const auto distance = [&](const std::array<double, 3>& at) {
    return glm::length(at[0] * a + at[1] * b + at[2] * c - p);
  };
  return *std::min_element(edges.begin(), edges.end(),
                           [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
}

/// The nearest triangle of those that face along the normal, of all for a normal of 0.
std::optional<SurfacePoint> nearest(const SurfaceTree& tree, const sim::Mesh& mesh, const Vec3& point,
                                    const Vec3& normal, double reach_m) {
  return tree.nearest(point, reach_m, [&](const SurfacePoint& found) {
    return glm::dot(sim::doubled_area_vector(mesh.positions, mesh.triangles[found.triangle]), normal) >= 0.0;
  });
}

/// The place of a bond, and axes that turn with the triangle: along its first edge, across, along the normal.
struct Frame {
  Vec3 place_m, along, across, normal;
};

Frame frame_of(const Bond& bond, std::span<const Vec3> positions_m, std::span<const Vec3> normals,
               std::span<const sim::Triangle> triangles) {
  const auto& [a, b, c] = triangles[bond.triangle];
  const auto& [u, v, w] = bond.weights;
  Frame frame;
  frame.place_m = u * positions_m[a] + v * positions_m[b] + w * positions_m[c];
  frame.normal = unit(u * normals[a] + v * normals[b] + w * normals[c]);
  const Vec3 edge = positions_m[b] - positions_m[a];
  frame.along = unit(edge - glm::dot(edge, frame.normal) * frame.normal);
  frame.across = glm::cross(frame.normal, frame.along);
  return frame;
}

}  // namespace

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions_m, std::span<const sim::Triangle> triangles) {
  std::vector<Vec3> normals(positions_m.size(), Vec3(0.0));
  for (const sim::Triangle& t : triangles) {
    const Vec3 area = glm::cross(positions_m[t[1]] - positions_m[t[0]], positions_m[t[2]] - positions_m[t[0]]);
    for (const Index v : t) {
      normals[v] += area;
    }
  }
  std::transform(normals.begin(), normals.end(), normals.begin(), unit);
  return normals;
}

std::vector<Bond> bonds_to(std::span<const Vec3> points_m, const sim::Mesh& mesh, std::span<const Vec3> normals) {
  const SurfaceTree tree(mesh.positions, mesh.triangles);
  const std::vector<Vec3> of_mesh = vertex_normals(mesh.positions, mesh.triangles);
  std::vector<Bond> bonds;
  bonds.reserve(points_m.size());
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    SurfacePoint found = nearest(tree, mesh, points_m[k], Vec3(0.0), infinite).value();
    if (!normals.empty()) {
      found = nearest(tree, mesh, points_m[k], normals[k], preferred * found.distance_m).value_or(found);
    }
    const auto& [a, b, c] = mesh.triangles[found.triangle];
    Bond bond{found.triangle, nearest_weights(found.place_m, mesh.positions[a], mesh.positions[b], mesh.positions[c])};
    const Frame frame = frame_of(bond, mesh.positions, of_mesh, mesh.triangles);
    const Vec3 offset_m = points_m[k] - frame.place_m;
    bond.offset_m = {glm::dot(offset_m, frame.along), glm::dot(offset_m, frame.across), glm::dot(offset_m, frame.normal)};
    bonds.push_back(bond);
  }
  return bonds;
}

std::vector<Vec3> follow(std::span<const Bond> bonds, std::span<const Vec3> positions_m,
                         std::span<const sim::Triangle> triangles) {
  const std::vector<Vec3> normals = vertex_normals(positions_m, triangles);
  std::vector<Vec3> points_m;
  points_m.reserve(bonds.size());
  for (const Bond& bond : bonds) {
    const Frame frame = frame_of(bond, positions_m, normals, triangles);
    points_m.push_back(frame.place_m + bond.offset_m.x * frame.along + bond.offset_m.y * frame.across +
                       bond.offset_m.z * frame.normal);
  }
  return points_m;
}

Index nearest_corner(const Bond& bond, std::span<const sim::Triangle> triangles) {
  const auto largest = std::max_element(bond.weights.begin(), bond.weights.end());
  return triangles[bond.triangle][static_cast<std::size_t>(largest - bond.weights.begin())];
}

}  // namespace taut::app
