#include "sim/mesh/topology.hpp"

#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Returns the number of vertices whose triangles form more than one fan.
std::size_t count_split_fans(const Mesh& mesh, const Adjacency& adjacency) {
  assert(are_below(mesh.triangles, mesh.positions.size()));
  Groups corners = find_fans(mesh.triangles, adjacency);
  std::vector<Index> fans(mesh.positions.size(), 0);
  for (Index c = 0; c < 3 * mesh.triangles.size(); ++c) fans[mesh.triangles[c / 3][c % 3]] += corners.find(c) == c;
  return static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), [](Index count) { return count > 1; }));
}

/// Returns the first vertex of each part connected by these edges or triangles, ascending.
template <class Simplices> std::vector<Index> first_vertices(std::size_t vertex_count, const Simplices& simplices) {
  Groups parts = connect_vertices(vertex_count, simplices);
  std::set<Index> first;
  for (const auto& simplex : simplices) first.insert(parts.find(simplex[0]));
  return {first.begin(), first.end()};
}

}  // namespace

bool runs_along(const Triangle& t, const Edge& edge) {
  for (int k = 0; k < 3; ++k) {
    if (t[k] == edge[0] && t[(k + 1) % 3] == edge[1]) return true;
  }
  return false;
}

bool is_misoriented(const Mesh& mesh, const Adjacency& adjacency, std::size_t edge) {
  assert(edge < adjacency.edges.size());
  const auto pair = adjacency.edge_triangles[edge];
  const auto along = [&](Index t) { return runs_along(mesh.triangles[t], adjacency.edges[edge]); };
  return pair.size() == 2 && along(pair[0]) == along(pair[1]);
}

Topology measure_topology(const Mesh& mesh, const Adjacency& adjacency) {
  Topology topology;
  const std::size_t vertex_count = mesh.positions.size();
  std::vector<Edge> boundary;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto triangles = adjacency.edge_triangles[e];
    if (triangles.size() == 1) boundary.push_back(adjacency.edges[e]);
    topology.non_manifold_edges += triangles.size() > 2;
    topology.misoriented_edges += is_misoriented(mesh, adjacency, e);
  }
  topology.boundary_edges = boundary.size();
  topology.components = first_vertices(vertex_count, adjacency.edges).size();
  topology.boundary_loops = first_vertices(vertex_count, boundary).size();
  topology.non_manifold_vertices = count_split_fans(mesh, adjacency);
  topology.euler_characteristic = static_cast<long>(vertex_count) - static_cast<long>(adjacency.edges.size()) +
                                  static_cast<long>(mesh.triangles.size());
  return topology;
}

std::vector<Index> first_vertices_of_parts(std::size_t vertex_count, std::span<const Triangle> triangles) {
  assert(are_below(triangles, vertex_count));
  return first_vertices(vertex_count, triangles);
}

Groups find_fans(std::span<const Triangle> triangles, const Adjacency& adjacency) {
  Groups fans(3 * triangles.size());
  const auto corner = [&](Index t, Index v) { return 3 * t + corner_at(triangles[t], v); };
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const std::span<const Index> around = adjacency.edge_triangles[e];
    for (const Index v : adjacency.edges[e]) {
      for (const Index t : around) fans.join(corner(around[0], v), corner(t, v));
    }
  }
  return fans;
}

std::vector<char> turns_to_agree(std::size_t triangle_count, std::span<const Joint> joints) {
  const CompressedRows triangle_joints = group_by_row(triangle_count, [&](const auto& visit) {
    for (Index j = 0; j < joints.size(); ++j) {
      visit(joints[j].a, j);
      visit(joints[j].b, j);
    }
  });
  std::vector<char> reached(triangle_count, 0), turned(triangle_count, 0);
  std::vector<Index> part;
  for (Index seed = 0; seed < triangle_count; ++seed) {
    if (reached[seed]) continue;
    part.assign(1, seed);
    reached[seed] = 1;
    std::size_t turned_in_part = 0;
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const Index j : triangle_joints[part[next]]) {
        const Index other = joints[j].a == part[next] ? joints[j].b : joints[j].a;
        if (std::exchange(reached[other], 1)) continue;
        turned[other] = turned[part[next]] != joints[j].run_alike;
        turned_in_part += turned[other];
        part.push_back(other);
      }
    }
    const bool the_others = 2 * turned_in_part > part.size();
    for (const Index t : part) turned[t] = turned[t] != the_others;
  }
  return turned;
}

std::size_t orient_consistently(Mesh& mesh) {
  const Adjacency adjacency = make_adjacency(mesh);
  std::vector<Joint> joints;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto pair = adjacency.edge_triangles[e];
    if (pair.size() == 2) {
      joints.push_back({adjacency.edges[e], pair[0], pair[1], is_misoriented(mesh, adjacency, e)});
    }
  }
  const std::vector<char> turned = turns_to_agree(mesh.triangles.size(), joints);
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
}

double winding_number(const Vec3& point_m, const Surface& surface) {
  double half_angles = 0.0;
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = surface.positions_m[t[0]] - point_m;
    const Vec3 b = surface.positions_m[t[1]] - point_m;
    const Vec3 c = surface.positions_m[t[2]] - point_m;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    half_angles += std::atan2(glm::dot(a, glm::cross(b, c)),
                              la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return half_angles / (2.0 * std::numbers::pi);
}

}  // namespace taut::sim
