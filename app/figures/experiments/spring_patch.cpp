#include "app/figures/experiments/spring_patch.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

namespace taut::app {
namespace {

struct View {
  sim::Vec3 origin_m, right, up;
};

SpringPatch patch_of(const sim::Garment& garment, const std::vector<sim::Index>& vertices, const View& view) {
  SpringPatch patch;
  std::map<sim::Index, std::size_t> place;
  for (const sim::Index vertex : vertices) {
    place[vertex] = patch.points_m.size();
    const sim::Vec3 from_origin = garment.mesh.positions[vertex] - view.origin_m;
    patch.points_m.emplace_back(glm::dot(from_origin, view.right), glm::dot(from_origin, view.up));
  }
  const sim::Springs& springs = garment.springs;
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
      const auto a = place.find(springs.ends[s][0]), b = place.find(springs.ends[s][1]);
      if (a != place.end() && b != place.end()) {
        patch.springs.push_back({{a->second, b->second}, kind});
      }
    }
  }
  return patch;
}

sim::Vec3 normal_around(const sim::Garment& garment, const std::vector<sim::Index>& vertices) {
  sim::Vec3 normal(0.0);
  for (const sim::Triangle& triangle : garment.mesh.triangles) {
    if (std::all_of(triangle.begin(), triangle.end(), [&](sim::Index corner) {
          return std::find(vertices.begin(), vertices.end(), corner) != vertices.end();
        })) {
      normal += sim::doubled_area_vector(garment.mesh.positions, triangle);
    }
  }
  return glm::normalize(normal);
}

}  // namespace

std::size_t SpringPatch::count(sim::SpringKind kind) const {
  return static_cast<std::size_t>(std::count_if(
      springs.begin(), springs.end(), [&](const PatchSpring& spring) { return spring.kind == kind; }));
}

SpringPatch whole_patch(const sim::Garment& garment) {
  std::vector<sim::Index> all(garment.mesh.positions.size());
  std::iota(all.begin(), all.end(), sim::Index{0});
  return patch_of(garment, all, {sim::Vec3(0.0), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
}

SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings) {
  std::vector<sim::Index> vertices = {vertex};
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<sim::Index> inner = vertices;
    for (const sim::Index v : inner) {
      for (const sim::Index edge : garment.adjacency.vertex_edges[v]) {
        const sim::Index neighbour = sim::other_end(garment.adjacency.edges[edge], v);
        if (std::find(vertices.begin(), vertices.end(), neighbour) == vertices.end()) {
          vertices.push_back(neighbour);
        }
      }
    }
  }
  const sim::Vec3 normal = normal_around(garment, vertices);
  const sim::Vec3 right = glm::normalize(glm::cross(sim::Vec3(0.0, 1.0, 0.0), normal));
  return patch_of(garment, vertices, {garment.mesh.positions[vertex], right, glm::cross(normal, right)});
}

}  // namespace taut::app
