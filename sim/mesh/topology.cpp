#include "sim/mesh/topology.hpp"

#include "sim/mesh/groups.hpp"

namespace taut::sim {
namespace {

/// Returns how many vertices have triangles that are not all connected through edges at the vertex.
std::size_t count_split_fans(const Mesh& mesh, const Adjacency& adjacency) {
  // Corner 3t + k is vertex k of triangle t; the corners of a fan are joined through the edges they share.
  Groups corners(mesh.triangles.size() * 3);
  const auto corner = [&](Index t, Index v) {
    const Triangle& tri = mesh.triangles[t];
    return static_cast<Index>(3 * t + (tri[1] == v ? 1 : tri[2] == v ? 2 : 0));
  };
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto triangles = adjacency.edge_triangles[e];
    for (std::size_t k = 1; k < triangles.size(); ++k) {
      for (const Index v : adjacency.edges[e]) corners.join(corner(triangles[0], v), corner(triangles[k], v));
    }
  }
  std::vector<Index> fans(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const auto c = static_cast<Index>(3 * t + k);
      fans[mesh.triangles[t][k]] += corners.find(c) == c;
    }
  }
  std::size_t split = 0;
  for (const Index count : fans) split += count > 1;
  return split;
}

template <class Selects>
std::size_t count_groups(std::size_t vertex_count, const Adjacency& adjacency, Selects selects) {
  Groups groups(vertex_count);
  std::vector<char> touched(vertex_count, 0);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (selects(e)) {
      const auto [a, b] = adjacency.edges[e];
      groups.join(a, b);
      touched[a] = touched[b] = 1;
    }
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    count += touched[v] && groups.find(static_cast<Index>(v)) == v;
  }
  return count;
}

struct Neighbour {
  Index triangle;
  bool disagrees;
};

/// Returns the triangles across the edges of each triangle, three entries per triangle. An entry that names
/// the triangle itself stands for no neighbour.
std::vector<Neighbour> neighbours_of(const Mesh& mesh) {
  const Adjacency adjacency = make_adjacency(mesh);
  std::vector<Neighbour> neighbours;
  for (Index t = 0; t < mesh.triangles.size(); ++t) neighbours.insert(neighbours.end(), 3, {t, false});
  std::vector<char> filled(mesh.triangles.size(), 0);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto pair = adjacency.edge_triangles[e];
    if (pair.size() == 2) {
      const bool disagrees = is_misoriented(mesh, adjacency, e);
      neighbours[3 * pair[0] + filled[pair[0]]++] = {pair[1], disagrees};
      neighbours[3 * pair[1] + filled[pair[1]]++] = {pair[0], disagrees};
    }
  }
  return neighbours;
}

}  // namespace

bool runs_along(const Triangle& t, const Edge& edge) {
  for (int k = 0; k < 3; ++k) {
    if (t[k] == edge[0] && t[(k + 1) % 3] == edge[1]) return true;
  }
  return false;
}

bool is_misoriented(const Mesh& mesh, const Adjacency& adjacency, std::size_t edge) {
  const auto pair = adjacency.edge_triangles[edge];
  const auto along = [&](Index t) { return runs_along(mesh.triangles[t], adjacency.edges[edge]); };
  return pair.size() == 2 && along(pair[0]) == along(pair[1]);
}

Topology measure_topology(const Mesh& mesh, const Adjacency& adjacency) {
  Topology topology;
  const std::size_t vertex_count = mesh.positions.size();
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto triangles = adjacency.edge_triangles[e];
    topology.boundary_edges += triangles.size() == 1;
    topology.non_manifold_edges += triangles.size() > 2;
    topology.misoriented_edges += is_misoriented(mesh, adjacency, e);
  }
  topology.components = count_groups(vertex_count, adjacency, [](std::size_t) { return true; });
  topology.boundary_loops =
      count_groups(vertex_count, adjacency, [&](std::size_t e) { return adjacency.edge_triangles[e].size() == 1; });
  topology.non_manifold_vertices = count_split_fans(mesh, adjacency);
  topology.euler_characteristic = static_cast<long>(vertex_count) - static_cast<long>(adjacency.edges.size()) +
                                  static_cast<long>(mesh.triangles.size());
  return topology;
}

std::vector<Index> first_vertices_of_parts(std::size_t vertex_count, std::span<const Triangle> triangles) {
  Groups parts(vertex_count);
  std::vector<bool> is_corner(vertex_count, false);
  for (const auto& [a, b, c] : triangles) {
    parts.join(a, b);
    parts.join(a, c);
    is_corner[a] = is_corner[b] = is_corner[c] = true;
  }
  std::vector<Index> first;
  for (Index v = 0; v < vertex_count; ++v) {
    if (is_corner[v] && parts.find(v) == v) first.push_back(v);
  }
  return first;
}

std::size_t orient_consistently(Mesh& mesh) {
  const std::vector<Neighbour> neighbours = neighbours_of(mesh);
  std::vector<char> reached(mesh.triangles.size(), 0), turned(mesh.triangles.size(), 0);
  std::size_t count = 0;
  std::vector<Index> part;
  for (Index seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (reached[seed]) continue;
    part.assign(1, seed);
    reached[seed] = 1;
    std::size_t turned_in_part = 0;
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (int k = 0; k < 3; ++k) {
        const Neighbour& neighbour = neighbours[3 * part[next] + k];
        if (!reached[neighbour.triangle]) {
          reached[neighbour.triangle] = 1;
          turned[neighbour.triangle] = turned[part[next]] != neighbour.disagrees;
          turned_in_part += turned[neighbour.triangle];
          part.push_back(neighbour.triangle);
        }
      }
    }
    const bool the_others = 2 * turned_in_part > part.size();
    for (const Index t : part) {
      if (turned[t] != the_others) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++count;
      }
    }
  }
  return count;
}

}  // namespace taut::sim
