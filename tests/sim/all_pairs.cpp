#include "all_pairs.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <set>

namespace taut::sim::bounded {
namespace {

using Corners = std::array<Vec3, 4>;

const Vec3& shorter(const Vec3& p, const Vec3& q) {
  return glm::length(p) <= glm::length(q) ? p : q;
}

/// Returns the shortest vector from the segment to p.
Vec3 from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double squared = glm::dot(ab, ab);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
  return p - (a + t * ab);
}

Vec3 from_triangle(const Corners& c) {
  const auto& [p, t0, t1, t2] = c;
  const Vec3 normal = glm::cross(t1 - t0, t2 - t0);
  const auto is_inside_of = [&](const Vec3& from, const Vec3& to) {
    return glm::dot(glm::cross(normal, to - from), c[0] - from) >= 0.0;
  };
  if (glm::length(normal) > 0.0 && is_inside_of(t0, t1) && is_inside_of(t1, t2) && is_inside_of(t2, t0)) {
    return glm::dot(normal, p - t0) / glm::dot(normal, normal) * normal;
  }
  return shorter(shorter(from_segment(p, t0, t1), from_segment(p, t1, t2)), from_segment(p, t2, t0));
}

Vec3 from_edge(const Corners& c) {
  const auto& [a, b, d, e] = c;
  const Vec3 normal = glm::cross(b - a, e - d);
  const double squared = glm::dot(normal, normal);
  if (squared > 0.0) {
    const double s = glm::dot(glm::cross(d - a, e - d), normal) / squared;
    const double t = glm::dot(glm::cross(d - a, b - a), normal) / squared;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
      return glm::dot(normal, a - d) / squared * normal;
    }
  }
  return shorter(shorter(from_segment(a, d, e), from_segment(b, d, e)),
                 shorter(-from_segment(d, a, b), -from_segment(e, a, b)));
}

struct ReachBox {
  glm::vec3 low{INFINITY};
  glm::vec3 high{-INFINITY};

  ReachBox(const Scene& scene, std::span<const Index> rows) {
    for (const Index row : rows) {
      const Float4& p = scene.positions[row];
      const Float4 m = scaled_sum(scene.moves[row], scene.together, -1.0F);
      const glm::vec3 begin(p.x, p.y, p.z);
      const glm::vec3 end = begin + glm::vec3(m.x, m.y, m.z);
      low = glm::min(low, glm::min(begin, end) - scene.radii[row]);
      high = glm::max(high, glm::max(begin, end) + scene.radii[row]);
    }
  }
};

}  // namespace

Gap measure_gap(const NearPair& pair, const Scene& scene) {
  const auto& rows = pair.rows;
  Corners p, m;
  for (Index k = 0; k < 4; ++k) {
    p[k] = to_vec3(scene.positions[rows[k]]);
    m[k] = to_vec3(scene.moves[rows[k]]);
  }
  const Vec3 line = pair.first_count == 1 ? from_triangle(p) : from_edge(p);
  const Vec3 normal = line / std::max(glm::length(line), 1e-30);
  Gap gap = {INFINITY, 0.0, 0.0};
  double radius[2] = {0.0, 0.0};
  double size = 0.0;
  for (Index k = 0; k < 4; ++k) {
    double& side = radius[k < pair.first_count ? 0 : 1];
    side = std::max(side, static_cast<double>(scene.radii[rows[k]]));
  }
  for (Index k = 0; k < pair.first_count; ++k) {
    for (Index l = pair.first_count; l < 4; ++l) {
      gap.gap_m = std::min(
          {gap.gap_m, glm::dot(normal, p[k] - p[l]), glm::dot(normal, (p[k] + m[k]) - (p[l] + m[l]))});
      size = std::max({size, glm::distance(p[k], p[l]), glm::distance(m[k], m[l])});
    }
  }
  gap.reach_m = radius[0] + radius[1];
  gap.tolerance_m =
      2e-5 * gap.reach_m + 2e-6 * size + 1e-7 * size * size / std::max(glm::length(line), 1e-30);
  return gap;
}

bool boxes_overlap(const NearPair& pair, const Scene& scene, double room_m) {
  const std::span<const Index> rows = pair.rows;
  const ReachBox a(scene, rows.first(pair.first_count));
  const ReachBox b(scene, rows.subspan(pair.first_count));
  return glm::all(glm::lessThanEqual(a.low - static_cast<float>(room_m), b.high)) && glm::all(glm::lessThanEqual(b.low - static_cast<float>(room_m), a.high));
}

std::vector<NearPair> all_pairs(const ContactMesh& mesh) {
  std::vector<NearPair> pairs;
  const auto add = [&](const NearPair& pair) {
    if (std::set<Index>(pair.rows.begin(), pair.rows.end()).size() == 4) {
      pairs.push_back(pair);
    }
  };
  const auto add_between = [&](const Primitives& vertices, const Primitives& triangles) {
    for (const auto& [v] : vertices.vertices) {
      for (const Triangle& t : triangles.triangles) {
        add({{v, t[0], t[1], t[2]}, 1});
      }
    }
  };
  add_between(mesh.cloth, mesh.cloth);
  add_between(mesh.cloth, mesh.bodies);
  add_between(mesh.bodies, mesh.cloth);
  std::vector<Edge> edges = mesh.cloth.edges;
  edges.insert(edges.end(), mesh.bodies.edges.begin(), mesh.bodies.edges.end());
  for (std::size_t i = 0; i < mesh.cloth.edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      add({{edges[i][0], edges[i][1], edges[j][0], edges[j][1]}, 2});
    }
  }
  return pairs;
}

}  // namespace taut::sim::bounded
