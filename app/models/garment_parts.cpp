#include "app/models/garment_parts.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

std::vector<Opening> openings_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups groups(mesh.positions.size());
  std::vector<double> lengths_m(mesh.positions.size(), 0.0);
  std::vector<sim::Index> at_border;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() == 1) {
      const auto [a, b] = adjacency.edges[e];
      groups.join(a, b);
      at_border.insert(at_border.end(), {a, b});
      lengths_m[a] += glm::distance(mesh.positions[a], mesh.positions[b]);
    }
  }
  std::sort(at_border.begin(), at_border.end());
  at_border.erase(std::unique(at_border.begin(), at_border.end()), at_border.end());
  std::map<sim::Index, Opening> openings;
  for (const sim::Index v : at_border) {
    Opening& opening = openings[groups.find(v)];
    opening.vertices.push_back(v);
    opening.length_m += lengths_m[v];
    opening.mean_height_m += mesh.positions[v].y;
    opening.range.add(mesh.positions[v]);
  }
  std::vector<Opening> list;
  for (auto& [first, opening] : openings) {
    opening.mean_height_m /= static_cast<double>(opening.vertices.size());
    list.push_back(std::move(opening));
  }
  return list;
}

}  // namespace

std::vector<GarmentPart> parts_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups groups(mesh.positions.size());
  for (const sim::Edge& edge : adjacency.edges) {
    groups.join(edge[0], edge[1]);
  }
  // A group's name is its first vertex, so that parts come in the order of their first vertices.
  std::vector<std::size_t> part_of(mesh.positions.size(), 0);
  std::vector<GarmentPart> parts;
  for (sim::Index v = 0; v < mesh.positions.size(); ++v) {
    const sim::Index first = groups.find(v);
    if (first == v) {
      part_of[v] = parts.size();
      parts.emplace_back();
    }
    GarmentPart& part = parts[part_of[v] = part_of[first]];
    part.vertices.push_back(v);
    part.range.add(mesh.positions[v]);
  }
  for (sim::Index triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const sim::Triangle& t = mesh.triangles[triangle];
    GarmentPart& part = parts[part_of[t[0]]];
    const double area_m2 = 0.5 * glm::length(sim::doubled_area_vector(mesh.positions, t));
    part.triangles.push_back(triangle);
    part.area_m2 += area_m2;
    part.centre_m += area_m2 / 3.0 * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
  }
  for (GarmentPart& part : parts) {
    part.centre_m /= part.area_m2;
  }
  for (Opening& opening : openings_of(mesh, adjacency)) {
    parts[part_of[opening.vertices.front()]].openings.push_back(std::move(opening));
  }
  return parts;
}

}  // namespace taut::app
