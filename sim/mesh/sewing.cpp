#include "sim/mesh/sewing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/point_cells.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::sim {
namespace {

// Cosine of the angle between the ways in which the cloth goes on from two borders. Above it one lies on the
// other. Side seams of a shirt that was modelled flat meet at some 10 degrees.
constexpr double layered = 0.99;

struct Nearest {
  double distance_m;
  Index vertex;

  auto operator<=>(const Nearest&) const = default;
};

/// Borders of a mesh and the parts they belong to.
struct Borders {
  Borders(const Mesh& source, double distance_m)
      : mesh(source), part_of(source.positions.size()), inwards(source.positions.size(), Vec3(0.0)) {
    const Adjacency adjacency = make_adjacency(mesh);
    for (const Edge& edge : adjacency.edges) {
      part_of.join(edge[0], edge[1]);
    }
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
      if (adjacency.edge_triangles[e].size() == 1) {
        add_inwards(adjacency.edges[e], mesh.triangles[adjacency.edge_triangles[e][0]]);
      }
    }
    PointCells cells(distance_m);
    for (Index v = 0; v < inwards.size(); ++v) {
      if (inwards[v] != Vec3(0.0)) {
        inwards[v] = glm::normalize(inwards[v]);
        vertices.push_back(v);
        cells.add(mesh.positions[v], v);
      }
    }
    nearest.resize(inwards.size());
    for (const Index v : vertices) {
      cells.visit_near(mesh.positions[v], [&](Index other) { note(v, other, distance_m); });
    }
  }

  bool lie_on_each_other(Index a, Index b) const { return glm::dot(inwards[a], inwards[b]) > layered; }

  /// Whether the two are each other's nearest.
  bool belong_together(Index a, Index b) {
    const auto back = nearest[b].find(part_of.find(a));
    return back != nearest[b].end() && back->second.vertex == a && !lie_on_each_other(a, b);
  }

  const Mesh& mesh;
  Groups part_of;
  std::vector<Vec3> inwards;    ///< by vertex: the way in which the cloth goes on from the border; 0 within
  std::vector<Index> vertices;  ///< at borders, ascending
  std::vector<std::map<Index, Nearest>> nearest;  ///< by vertex, then by part

 private:
  void add_inwards(const Edge& edge, const Triangle& t) {
    const Vec3 along = glm::normalize(mesh.positions[edge[1]] - mesh.positions[edge[0]]);
    for (const Index v : t) {
      if (v != edge[0] && v != edge[1]) {
        const Vec3 way = mesh.positions[v] - mesh.positions[edge[0]];
        const Vec3 inward = glm::normalize(way - glm::dot(way, along) * along);
        inwards[edge[0]] += inward;
        inwards[edge[1]] += inward;
      }
    }
  }

  void note(Index v, Index other, double distance_m) {
    const Index part = part_of.find(other);
    const Nearest found{glm::distance(mesh.positions[v], mesh.positions[other]), other};
    if (part != part_of.find(v) && found.distance_m < distance_m) {
      const auto [best, is_new] = nearest[v].try_emplace(part, found);
      best->second = std::min(best->second, found);
    }
  }
};

/// Whether all of these may become one.
bool are_unambiguous(Borders& borders, const std::vector<Index>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (borders.part_of.find(vertices[i]) == borders.part_of.find(vertices[k]) ||
          borders.lie_on_each_other(vertices[i], vertices[k])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::size_t sew_parts(double distance_m, const Mesh& mesh, std::vector<Index>& welded) {
  Mesh joined{mesh.positions, mesh.triangles, {}};
  renumber(welded, joined);
  Borders borders(joined, distance_m);
  Groups places(mesh.positions.size());
  for (const Index v : borders.vertices) {
    for (const auto& [part, near] : borders.nearest[v]) {
      if (borders.belong_together(v, near.vertex)) {
        places.join(v, near.vertex);
      }
    }
  }
  std::map<Index, std::vector<Index>> seams;
  for (const Index v : borders.vertices) {
    seams[places.find(v)].push_back(v);
  }
  std::vector<Index> sewn(mesh.positions.size());
  std::iota(sewn.begin(), sewn.end(), Index{0});
  std::size_t count = 0;
  for (const auto& [first, vertices] : seams) {
    if (are_unambiguous(borders, vertices)) {
      count += vertices.size() - 1;
      for (const Index v : vertices) {
        sewn[v] = first;
      }
    }
  }
  for (Index& v : welded) {
    v = sewn[v];
  }
  return count;
}

}  // namespace taut::sim
