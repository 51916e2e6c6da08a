#include "sim/mesh/welding.hpp"

#include "sim/mesh/point_cells.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::sim {
namespace {

constexpr Index none = no_vertex;

struct PositionHash {
  std::size_t operator()(const Vec3& p) const { return hash_of(p.x, p.y, p.z); }
};

/// Returns, per vertex, 1 if an edge with only one triangle ends there.
std::vector<char> border_vertices(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<char> at_border(mesh.positions.size(), 0);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() == 1) {
      at_border[adjacency.edges[e][0]] = at_border[adjacency.edges[e][1]] = 1;
    }
  }
  return at_border;
}

/// A first guess: a vertex with triangles all around it stays alone; the others at a place become one.
std::vector<Index> join_open_vertices(const Mesh& mesh, const std::vector<Index>& places) {
  const std::vector<char> open = border_vertices(mesh, make_adjacency(mesh));
  const std::vector<char> used = used_vertices(mesh);
  std::vector<Index> first_open(mesh.positions.size(), none);
  std::vector<Index> joined(places.size());
  for (Index v = 0; v < places.size(); ++v) {
    Index& first = first_open[places[v]];
    const bool closed = used[v] && !open[v];
    first = first == none && !closed ? v : first;
    joined[v] = closed ? v : first;
  }
  return joined;
}

/// The corners of a mesh, joined into the fans they form around their vertices. Corner 3t + k is corner k of
/// triangle t.
struct Fans {
  Fans(const Mesh& source, const Mesh& joined, const Adjacency& adjacency)
      : groups(fans_of(joined.triangles, adjacency)), is_open(3 * source.triangles.size(), 0) {
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
      const Index t = adjacency.edge_triangles[e][0];
      for (const Index v : adjacency.edges[e]) {
        if (adjacency.edge_triangles[e].size() == 1) is_open[3 * t + corner_at(joined.triangles[t], v)] = 1;
      }
    }
    join_corners_of_one_vertex(source);
    for (Index c = 0; c < is_open.size(); ++c) {
      if (is_open[c]) is_open[groups.find(c)] = 1;
    }
  }

  Groups groups;
  std::vector<char> is_open;  ///< by corner; of a group's first corner: of the group

 private:
  // Corners that share a vertex in the file stay together.
  void join_corners_of_one_vertex(const Mesh& source) {
    std::vector<Index> first(source.positions.size(), none);
    for (Index c = 0; c < 3 * source.triangles.size(); ++c) {
      Index& other = first[source.triangles[c / 3][c % 3]];
      other = other == none ? c : other;
      groups.join(other, c);
    }
  }
};

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
      : mesh(source),
        part_of(connected(source.positions.size(), source.triangles)),
        inwards(source.positions.size(), Vec3(0.0)) {
    const Adjacency adjacency = make_adjacency(mesh);
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

Mesh renumbered(const Mesh& mesh, const std::vector<Index>& vertices) {
  Mesh result{mesh.positions, mesh.triangles, {}};
  for (Triangle& t : result.triangles) t = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  return result;
}

Groups pieces_of(const Mesh& mesh) {
  const std::vector<Index> places = first_at_same_position(mesh.positions);
  Groups pieces = connected(mesh.positions.size(), mesh.triangles);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) pieces.join(places[v], v);
  }
  return pieces;
}

std::vector<char> used_vertices(const Mesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) used[v] = 1;
  }
  return used;
}

std::vector<Index> first_at_same_position(const std::vector<Vec3>& positions) {
  std::unordered_map<Vec3, Index, PositionHash> first;
  first.reserve(positions.size());
  std::vector<Index> result(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    result[v] = first.emplace(positions[v], static_cast<Index>(v)).first->second;
  }
  return result;
}

std::vector<Index> weld_at_places(const Mesh& mesh, const std::vector<Index>& places) {
  std::vector<Index> joined = join_open_vertices(mesh, places);
  const Mesh guess = renumbered(mesh, joined);
  Fans fans(mesh, guess, make_adjacency(guess));
  // Closed fans of different vertices at one place become vertices of their own, the open ones stay together.
  Groups together(mesh.positions.size());
  std::vector<Index> open_at(mesh.positions.size(), none);
  std::vector<Index> vertex_of_fan(fans.is_open.size(), none);
  for (Index c = 0; c < fans.is_open.size(); ++c) {
    const Index vertex = mesh.triangles[c / 3][c % 3];
    const Index fan = fans.groups.find(c);
    Index& same = fans.is_open[fan] ? open_at[joined[vertex]] : vertex_of_fan[fan];
    same = same == none ? vertex : same;
    together.join(same, vertex);
  }
  const std::vector<char> used = used_vertices(mesh);
  for (Index v = 0; v < joined.size(); ++v) {
    joined[v] = used[v] ? together.find(v) : places[v] == v ? v : joined[places[v]];
  }
  return joined;
}

std::size_t weld_near_borders(double distance_m, const Mesh& mesh, std::vector<Index>& welded) {
  const Mesh joined = renumbered(mesh, welded);
  const std::vector<char> at_border = border_vertices(joined, make_adjacency(joined));
  PointCells cells(distance_m);
  Groups groups(mesh.positions.size());
  std::size_t count = 0;
  for (Index v = 0; v < at_border.size(); ++v) {
    if (!at_border[v]) continue;
    const Vec3& p = mesh.positions[v];
    cells.visit_near(p, [&](Index near) {
      if (glm::distance(mesh.positions[near], p) < distance_m && groups.find(near) != groups.find(v)) {
        groups.join(near, v);
        ++count;
      }
    });
    cells.add(p, v);
  }
  for (Index& v : welded) v = groups.find(v);
  return count;
}

std::size_t sew_parts(double distance_m, const Mesh& mesh, std::vector<Index>& welded) {
  const Mesh joined = renumbered(mesh, welded);
  Borders borders(joined, distance_m);
  Groups places(mesh.positions.size());
  for (const Index v : borders.vertices) {
    for (const auto& [part, near] : borders.nearest[v]) {
      if (borders.belong_together(v, near.vertex)) places.join(v, near.vertex);
    }
  }
  std::map<Index, std::vector<Index>> seams;
  for (const Index v : borders.vertices) seams[places.find(v)].push_back(v);
  std::vector<Index> sewn(mesh.positions.size());
  std::iota(sewn.begin(), sewn.end(), Index{0});
  std::size_t count = 0;
  for (const auto& [first, vertices] : seams) {
    if (are_unambiguous(borders, vertices)) {
      count += vertices.size() - 1;
      for (const Index v : vertices) sewn[v] = first;
    }
  }
  for (Index& v : welded) v = sewn[v];
  return count;
}

}  // namespace taut::sim
