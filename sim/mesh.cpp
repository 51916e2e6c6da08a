#include "sim/mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>
#include <unordered_map>

namespace taut::sim {
namespace {

struct PositionHash {
  std::size_t operator()(const Vec3& p) const {
    std::size_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // Adding zero turns -0 into +0, which compares equal and so has to hash equal.
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

void require_well_formed(const Mesh& mesh) {
  if (!mesh.quads.empty()) {
    throw std::invalid_argument("a mesh with grid cells cannot be welded");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw std::invalid_argument("vertex " + std::to_string(v) + " has a coordinate that is not finite");
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      if (v >= mesh.positions.size()) {
        throw std::invalid_argument("triangle " + std::to_string(t) + " uses vertex " + std::to_string(v) +
                                    ", but there are only " + std::to_string(mesh.positions.size()) +
                                    " vertices");
      }
    }
  }
}

/// For each vertex the first vertex at exactly the same position.
std::vector<Index> first_at_same_position(const std::vector<Vec3>& positions) {
  std::unordered_map<Vec3, Index, PositionHash> first;
  first.reserve(positions.size());
  std::vector<Index> result(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    result[v] = first.emplace(positions[v], static_cast<Index>(v)).first->second;
  }
  return result;
}

bool is_degenerate(const std::vector<Vec3>& positions, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
    return true;
  }
  const Vec3 area = doubled_area_vector(positions, t);
  return !(glm::dot(area, area) > 0.0);
}

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Drops the vertices no triangle uses and renumbers the rest. Returns how many were dropped.
std::size_t compact_vertices(Mesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      used[v] = 1;
    }
  }
  std::vector<Index> renumbered(mesh.positions.size());
  Index kept = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    renumbered[v] = kept;
    if (used[v]) {
      mesh.positions[kept++] = mesh.positions[v];
    }
  }
  const std::size_t dropped = mesh.positions.size() - kept;
  mesh.positions.resize(kept);
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t) {
      v = renumbered[v];
    }
  }
  return dropped;
}

}  // namespace

Vec3 doubled_area_vector(const std::vector<Vec3>& positions, const Triangle& t) {
  return glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

double surface_area(const Mesh& mesh) {
  double doubled = 0.0;
  for (const Triangle& t : mesh.triangles) {
    doubled += glm::length(doubled_area_vector(mesh.positions, t));
  }
  return doubled / 2.0;
}

ValidatedMesh weld_and_validate(const Mesh& input) {
  require_well_formed(input);
  ValidatedMesh out;
  out.report.input_vertices = input.positions.size();
  out.report.input_triangles = input.triangles.size();
  out.mesh.positions = input.positions;

  const std::vector<Index> first = first_at_same_position(input.positions);
  for (std::size_t v = 0; v < first.size(); ++v) {
    out.report.welded_vertices += first[v] != v;
  }
  std::set<Triangle> seen;
  for (const Triangle& raw : input.triangles) {
    const Triangle t = {first[raw[0]], first[raw[1]], first[raw[2]]};
    if (is_degenerate(input.positions, t)) {
      ++out.report.degenerate_triangles;
    } else if (!seen.insert(sorted(t)).second) {
      ++out.report.duplicate_triangles;
    } else {
      out.mesh.triangles.push_back(t);
    }
  }
  if (out.mesh.triangles.empty()) {
    throw std::invalid_argument("no triangle with an area remains of " +
                                std::to_string(input.triangles.size()) + " triangles");
  }
  out.report.unused_vertices = compact_vertices(out.mesh) - out.report.welded_vertices;
  return out;
}

}  // namespace taut::sim
