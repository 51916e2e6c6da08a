#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::test {

/// Plane section of a mesh around a point. Among its closed curves it measures the one whose mean position is nearest
/// to the point.
class Section {
 public:
  Section(const sim::Mesh& mesh, const sim::Vec3& point, const sim::Vec3& normal) {
    const sim::Vec3 aside = glm::normalize(glm::cross(normal, sim::Vec3(0.3, 0.2, 0.9)));
    const auto height = [&](sim::Index v) { return glm::dot(mesh.positions[v] - point, normal); };
    // The two edges at which the plane cuts a triangle belong to the same curve.
    std::map<std::pair<sim::Index, sim::Index>, sim::Index> cuts;
    std::vector<sim::Vec2> found;
    for (const sim::Triangle& t : mesh.triangles) {
      std::vector<sim::Index> of_triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        if ((height(a) > 0.0) == (height(b) > 0.0)) {
          continue;
        }
        const auto [cut, is_new] = cuts.try_emplace({a, b}, static_cast<sim::Index>(found.size()));
        of_triangle.push_back(cut->second);
        if (is_new) {
          const double s = height(a) / (height(a) - height(b));
          const sim::Vec3 p = mesh.positions[a] + s * (mesh.positions[b] - mesh.positions[a]) - point;
          found.emplace_back(glm::dot(p, aside), glm::dot(p, glm::cross(normal, aside)));
          groups_.push_back(cut->second);
        }
      }
      if (of_triangle.size() == 2) {
        groups_[group(of_triangle[0])] = group(of_triangle[1]);
      }
    }
    for (sim::Index cut = 0; cut < found.size(); ++cut) {
      curves_[group(cut)].push_back(found[cut]);
    }
  }

  /// Length of the convex hull of the curve nearest to the point, in metres.
  double tight_tape_m() const {
    const auto distance = [](const std::vector<sim::Vec2>& curve) {
      return glm::length(std::accumulate(curve.begin(), curve.end(), sim::Vec2(0.0))) /
             static_cast<double>(curve.size());
    };
    const auto nearest = std::min_element(curves_.begin(), curves_.end(), [&](const auto& a, const auto& b) {
      return distance(a.second) < distance(b.second);
    });
    return nearest == curves_.end() ? 0.0 : wrapped_m(nearest->second);
  }

 private:
  sim::Index group(sim::Index v) {
    while (groups_[v] != v) {
      v = groups_[v] = groups_[groups_[v]];
    }
    return v;
  }

  /// Length of the convex hull by gift wrapping (Jarvis 1973): each step goes to the point that leaves no other on
  /// its right.
  static double wrapped_m(const std::vector<sim::Vec2>& points) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      at = points[i].x < points[at].x ? i : at;
    }
    const sim::Vec2 first = points[at];
    double length_m = 0.0;
    for (std::size_t steps = 0; steps < points.size(); ++steps) {
      std::size_t next = at;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const sim::Vec2 to_next = points[next] - points[at];
        const sim::Vec2 to_i = points[i] - points[at];
        const double turn = to_next.x * to_i.y - to_next.y * to_i.x;
        const bool farther = glm::dot(to_i, to_i) > glm::dot(to_next, to_next);
        next = turn < 0.0 || (turn == 0.0 && farther) ? i : next;
      }
      length_m += glm::length(points[next] - points[at]);
      at = next;
      if (points[at] == first) {
        break;
      }
    }
    return length_m;
  }

  std::vector<sim::Index> groups_;
  std::map<sim::Index, std::vector<sim::Vec2>> curves_;
};

}  // namespace taut::test
