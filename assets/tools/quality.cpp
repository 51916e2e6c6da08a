#include "tailor/quality.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tailor/crossings.hpp"

namespace taut::tailor {
namespace {

using sim::Vec3;

double angle_deg(const Vec3& at, const Vec3& a, const Vec3& b) {
  const double cosine = glm::dot(a - at, b - at) / (glm::length(a - at) * glm::length(b - at));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * (180.0 / 3.141592653589793);
}

double smallest_angle_deg(const sim::Mesh& mesh) {
  double smallest = 180.0;
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      smallest = std::min(smallest, angle_deg(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]],
                                              mesh.positions[t[(k + 2) % 3]]));
    }
  }
  return smallest;
}

void measure_edges(const sim::Mesh& mesh, const sim::Adjacency& adjacency, MeshQuality& quality) {
  quality.shortest_edge_m = 1e9;
  double sum_m = 0.0;
  for (const auto& [a, b] : adjacency.edges) {
    const double length_m = glm::length(mesh.positions[a] - mesh.positions[b]);
    quality.shortest_edge_m = std::min(quality.shortest_edge_m, length_m);
    quality.longest_edge_m = std::max(quality.longest_edge_m, length_m);
    sum_m += length_m;
  }
  quality.mean_edge_m = sum_m / static_cast<double>(adjacency.edges.size());
}

/// Six times the volume under each triangle as seen from the centre, which stands in for the missing caps.
double volume_m3(const sim::Mesh& mesh) {
  Vec3 centre(0.0);
  for (const Vec3& p : mesh.positions) {
    centre += p;
  }
  centre /= static_cast<double>(mesh.positions.size());
  double sextuple = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    sextuple += glm::dot(mesh.positions[t[0]] - centre, sim::doubled_area_vector(mesh.positions, t));
  }
  return sextuple / 6.0;
}

}  // namespace

MeshQuality measure_quality(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  MeshQuality quality;
  quality.vertices = mesh.positions.size();
  quality.triangles = mesh.triangles.size();
  quality.smallest_angle_deg = smallest_angle_deg(mesh);
  measure_edges(mesh, adjacency, quality);
  quality.area_m2 = sim::surface_area(mesh);
  quality.volume_m3 = volume_m3(mesh);
  quality.crossings = count_crossings(mesh, adjacency);
  quality.topology = sim::measure_topology(mesh, adjacency);
  return quality;
}

}  // namespace taut::tailor
