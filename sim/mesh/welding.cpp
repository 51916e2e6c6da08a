#include "sim/mesh/welding.hpp"

#include "sim/mesh/point_cells.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::sim {
namespace {

constexpr Index none = no_vertex;

struct PositionHash {
  std::size_t operator()(const Vec3& p) const { return hash_numbers(p.x, p.y, p.z); }
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

/// Returns a first guess: vertices surrounded by triangles stay alone; the others at a position become one.
std::vector<Index> join_open_vertices(const Mesh& mesh, const std::vector<Index>& places) {
  assert(places.size() == mesh.positions.size());
  const std::vector<char> open = border_vertices(mesh, make_adjacency(mesh));
  const std::vector<char> used = used_vertices(mesh);
  std::vector<Index> first_open(mesh.positions.size(), none);
  std::vector<Index> joined_vertices(places.size());
  for (Index v = 0; v < places.size(); ++v) {
    Index& first = first_open[places[v]];
    const bool closed = used[v] && !open[v];
    first = first == none && !closed ? v : first;
    joined_vertices[v] = closed ? v : first;
  }
  return joined_vertices;
}

/// Corners of a mesh, joined into fans around their vertices. Corner 3t + k is corner k of triangle t.
struct Fans {
  Fans(const Mesh& source, const Mesh& joined_vertices, const Adjacency& adjacency)
      : groups(find_fans(joined_vertices.triangles, adjacency)), is_open(3 * source.triangles.size(), 0) {
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
      const Index t = adjacency.edge_triangles[e][0];
      for (const Index v : adjacency.edges[e]) {
        if (adjacency.edge_triangles[e].size() == 1) is_open[3 * t + corner_at(joined_vertices.triangles[t], v)] = 1;
      }
    }
    join_corners_of_one_vertex(source);
    for (Index c = 0; c < is_open.size(); ++c) {
      if (is_open[c]) is_open[groups.find(c)] = 1;
    }
  }

  Groups groups;
  std::vector<char> is_open;  ///< flag per corner; a group's first corner holds the value of the group

 private:
  // Joins corners that share a vertex in the file.
  void join_corners_of_one_vertex(const Mesh& source) {
    std::vector<Index> first(source.positions.size(), none);
    for (Index c = 0; c < 3 * source.triangles.size(); ++c) {
      Index& other = first[source.triangles[c / 3][c % 3]];
      other = other == none ? c : other;
      groups.join(other, c);
    }
  }
};

// Cosine of the angle between the inward directions of two borders above which one part lies on the other. The side
// seams of a shirt modelled flat meet at some 10 degrees.
constexpr double min_overlap_cosine = 0.99;

struct BorderNeighbour {
  double distance_m;
  Index vertex;

  auto operator<=>(const BorderNeighbour&) const = default;
};

/// Borders of a mesh, with the parts of their vertices.
struct Borders {
  Borders(const Mesh& source, double distance_m)
      : mesh(source),
        part_groups(connect_vertices(source.positions.size(), source.triangles)),
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
    nearest_by_part.resize(inwards.size());
    for (const Index v : vertices) {
      cells.visit_near(mesh.positions[v], [&](Index other) { note(v, other, distance_m); });
    }
  }

  bool lie_on_each_other(Index a, Index b) const { return glm::dot(inwards[a], inwards[b]) > min_overlap_cosine; }

  /// Returns whether the two are each other's nearest and do not lie on each other.
  bool belong_together(Index a, Index b) {
    const auto back = nearest_by_part[b].find(part_groups.find(a));
    return back != nearest_by_part[b].end() && back->second.vertex == a && !lie_on_each_other(a, b);
  }

  const Mesh& mesh;
  Groups part_groups;
  std::vector<Vec3> inwards;                      ///< inward direction from the border per vertex; 0 within
  std::vector<Index> vertices;                    ///< border vertices, ascending
  std::vector<std::map<Index, BorderNeighbour>> nearest_by_part;  ///< nearest border vertex per vertex and other part

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
    const Index part = part_groups.find(other);
    const BorderNeighbour found{glm::distance(mesh.positions[v], mesh.positions[other]), other};
    if (part != part_groups.find(v) && found.distance_m < distance_m) {
      const auto [best, is_new] = nearest_by_part[v].try_emplace(part, found);
      best->second = std::min(best->second, found);
    }
  }
};

/// Returns whether all of these vertices may become one.
bool are_unambiguous(Borders& borders, const std::vector<Index>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (borders.part_groups.find(vertices[i]) == borders.part_groups.find(vertices[k]) ||
          borders.lie_on_each_other(vertices[i], vertices[k])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

Mesh renumber_corners(const Mesh& mesh, const std::vector<Index>& vertices) {
  Mesh result{mesh.positions, mesh.triangles, {}};
  for (Triangle& t : result.triangles) t = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  return result;
}

Groups find_pieces(const Mesh& mesh) {
  const std::vector<Index> places = first_at_same_position(mesh.positions);
  Groups pieces = connect_vertices(mesh.positions.size(), mesh.triangles);
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
  assert(places.size() == mesh.positions.size());
  std::vector<Index> joined_vertices = join_open_vertices(mesh, places);
  const Mesh guess = renumber_corners(mesh, joined_vertices);
  Fans fans(mesh, guess, make_adjacency(guess));
  // Closed fans of different vertices at one position become separate vertices; open fans become one.
  Groups together(mesh.positions.size());
  std::vector<Index> open_at(mesh.positions.size(), none);
  std::vector<Index> vertex_of_fan(fans.is_open.size(), none);
  for (Index c = 0; c < fans.is_open.size(); ++c) {
    const Index vertex = mesh.triangles[c / 3][c % 3];
    const Index fan = fans.groups.find(c);
    Index& same = fans.is_open[fan] ? open_at[joined_vertices[vertex]] : vertex_of_fan[fan];
    same = same == none ? vertex : same;
    together.join(same, vertex);
  }
  const std::vector<char> used = used_vertices(mesh);
  for (Index v = 0; v < joined_vertices.size(); ++v) {
    joined_vertices[v] = used[v] ? together.find(v) : places[v] == v ? v : joined_vertices[places[v]];
  }
  return joined_vertices;
}

std::size_t weld_near_borders(double distance_m, const Mesh& mesh, std::vector<Index>& welded) {
  assert(distance_m >= 0.0);
  assert(welded.size() == mesh.positions.size());
  const Mesh joined_vertices = renumber_corners(mesh, welded);
  const std::vector<char> at_border = border_vertices(joined_vertices, make_adjacency(joined_vertices));
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
  assert(distance_m >= 0.0);
  assert(welded.size() == mesh.positions.size());
  const Mesh joined_vertices = renumber_corners(mesh, welded);
  Borders borders(joined_vertices, distance_m);
  Groups places(mesh.positions.size());
  for (const Index v : borders.vertices) {
    for (const auto& [part, near] : borders.nearest_by_part[v]) {
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
