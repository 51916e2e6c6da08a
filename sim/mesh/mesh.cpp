#include "sim/mesh/mesh.hpp"

#include <unordered_set>

#include "sim/mesh/point_cells.hpp"
#include "sim/mesh/preconditions.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::sim {
namespace {

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
                                    ", but there are only " + std::to_string(mesh.positions.size()) + " vertices");
      }
    }
  }
}

struct TriangleHash {
  std::size_t operator()(const Triangle& t) const {
    std::size_t hash = 0;
    for (const Index v : t) hash = mix_hash(hash, v);
    return hash;
  }
};

/// Drops triangles without area and duplicate triangles, judged by the replacement vertices in `vertices`, one per
/// vertex.
void drop_unsound(const std::vector<Index>& vertices, Mesh& mesh, MeshReport& report) {
  assert(vertices.size() == mesh.positions.size());
  std::unordered_set<Triangle, TriangleHash> seen;
  seen.reserve(mesh.triangles.size());
  std::size_t kept_count = 0;
  for (const Triangle& raw : mesh.triangles) {
    Triangle t = {vertices[raw[0]], vertices[raw[1]], vertices[raw[2]]};
    const bool is_sound = has_area(mesh.positions, t);
    std::sort(t.begin(), t.end());
    if (!is_sound) {
      ++report.degenerate_triangles;
    } else if (!seen.insert(t).second) {
      ++report.duplicate_triangles;
    } else {
      mesh.triangles[kept_count++] = raw;
    }
  }
  mesh.triangles.resize(kept_count);
}

/// Returns the number of used vertices minus the number of their distinct positions.
std::size_t count_unwelded(const Mesh& mesh, const std::vector<Index>& places, const std::vector<Index>& welded) {
  const auto count_used = [&](const std::vector<Index>& named) {
    const std::vector<char> used = used_vertices(renumber_corners(mesh, named));
    return std::count(used.begin(), used.end(), 1);
  };
  return static_cast<std::size_t>(count_used(welded) - count_used(places));
}

/// Drops unused vertices and renumbers the others. Returns the new index per old vertex, or `no_vertex`.
std::vector<Index> compact_vertices(Mesh& mesh) {
  const std::vector<char> used = used_vertices(mesh);
  std::vector<Index> number(mesh.positions.size(), no_vertex);
  Index kept_count = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (used[v]) {
      number[v] = kept_count;
      mesh.positions[kept_count++] = mesh.positions[v];
    }
  }
  mesh.positions.resize(kept_count);
  mesh = renumber_corners(mesh, number);
  return number;
}

}  // namespace

Vec3 doubled_area_vector(std::span<const Vec3> positions, const Triangle& t) {
  assert(are_below(std::span(&t, 1), positions.size()));
  return glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

// Two equal corners make the cross product exactly 0.
bool has_area(std::span<const Vec3> positions, const Triangle& t) {
  const Vec3 area = doubled_area_vector(positions, t);
  return glm::dot(area, area) > 0.0;
}

std::array<Vec3, 3> corner_positions(const Triangle& t, std::span<const Vec3> positions) {
  assert(are_below(std::span(&t, 1), positions.size()));
  return {positions[t[0]], positions[t[1]], positions[t[2]]};
}

std::array<Vec3, 3> corners_at_rest(const Mesh& mesh, std::size_t triangle) {
  assert(triangle < mesh.triangles.size());
  if (mesh.cut_m.empty()) return corner_positions(mesh.triangles[triangle], mesh.positions);
  const auto& [a, b, c] = mesh.cut_m[triangle];
  return {Vec3(a, 0.0), Vec3(b, 0.0), Vec3(c, 0.0)};
}

double surface_area(const Mesh& mesh) {
  double doubled = 0.0;
  for (const Triangle& t : mesh.triangles) {
    doubled += glm::length(doubled_area_vector(mesh.positions, t));
  }
  return doubled / 2.0;
}

ValidatedMesh weld_and_validate(const Mesh& input, const RepairSettings& settings) {
  require_well_formed(input);
  ValidatedMesh out{{input.positions, input.triangles, {}}, {}, {}};
  Mesh& mesh = out.mesh;
  MeshReport& report = out.report;
  report.input_vertices = input.positions.size();
  report.input_triangles = input.triangles.size();

  const std::vector<Index> places = first_at_same_position(mesh.positions);
  drop_unsound(places, mesh, report);
  std::vector<Index> welded = weld_at_places(mesh, places);
  for (std::size_t v = 0; v < welded.size(); ++v) {
    report.welded_vertices += welded[v] != v;
  }
  report.unwelded_vertices = count_unwelded(mesh, places, welded);
  if (settings.weld_distance_m > 0.0) {
    report.near_vertices = weld_near_borders(settings.weld_distance_m, mesh, welded);
    drop_unsound(welded, mesh, report);
  }
  if (settings.sewing_distance_m > 0.0) {
    report.sewn_vertices = sew_parts(settings.sewing_distance_m, mesh, welded);
    drop_unsound(welded, mesh, report);
  }
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("no triangle with an area remains of " + std::to_string(input.triangles.size()) +
                                " triangles");
  }
  mesh = renumber_corners(mesh, welded);
  report.turned_triangles = orient_consistently(mesh);
  const std::vector<Index> number = compact_vertices(mesh);
  const std::size_t dropped = input.positions.size() - mesh.positions.size();
  report.unused_vertices = dropped - report.welded_vertices - report.near_vertices - report.sewn_vertices;
  const std::vector<char> used = used_vertices(input);
  for (std::size_t v = 0; v < used.size(); ++v) {
    // An unused vertex has no result vertex, even if another vertex at its position has one.
    out.result_vertices.push_back(used[v] ? number[welded[v]] : no_vertex);
  }
  return out;
}

}  // namespace taut::sim
