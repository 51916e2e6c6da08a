#include "app/fitting/sheets.hpp"

#include "sim/mesh/groups.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

/// Two triangles that stay together at an edge.
struct Joint {
  sim::Edge edge;
  sim::Index a, b;
  bool run_alike;  ///< both run along the edge the same way: they face different sides
};

/// How smoothly the surface goes on from one triangle to another: the negative cosine between the ways from
/// the edge into both.
double smoothness(const sim::Mesh& mesh, const sim::Edge& edge, const sim::Triangle& a, const sim::Triangle& b) {
  const sim::Vec3 along = mesh.positions[edge[1]] - mesh.positions[edge[0]];
  const auto inwards = [&](const sim::Triangle& t) {
    for (const sim::Index v : t) {
      if (v != edge[0] && v != edge[1]) {
        const sim::Vec3 way = mesh.positions[v] - mesh.positions[edge[0]];
        return way - glm::dot(way, along) / glm::dot(along, along) * along;
      }
    }
    return sim::Vec3(0.0);
  };
  const sim::Vec3 x = inwards(a), y = inwards(b);
  const double lengths = glm::length(x) * glm::length(y);
  return lengths > 0.0 ? -glm::dot(x, y) / lengths : -2.0;
}

/// Returns the two of these triangles between which the surface goes on most smoothly.
std::array<sim::Index, 2> smoothest(const sim::Mesh& mesh, const sim::Edge& edge, std::span<const sim::Index> around) {
  std::array<sim::Index, 2> smoothest = {around[0], around[1]};
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; around.size() > 2 && i < around.size(); ++i) {
    for (std::size_t k = i + 1; k < around.size(); ++k) {
      const double found = smoothness(mesh, edge, mesh.triangles[around[i]], mesh.triangles[around[k]]);
      if (found > best) {
        best = found;
        smoothest = {around[i], around[k]};
      }
    }
  }
  return smoothest;
}

/// At an edge of more than two triangles the two between which the surface goes on most smoothly stay
/// together, and so on with the rest: layers that were welded to each other are many.
std::vector<Joint> choose_joints(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  std::vector<Joint> joints;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const sim::Edge& edge = adjacency.edges[e];
    const std::span<const sim::Index> triangles = adjacency.edge_triangles[e];
    std::vector<sim::Index> around(triangles.begin(), triangles.end());
    while (around.size() > 1) {
      const auto [a, b] = smoothest(mesh, edge, around);
      joints.push_back(
          {edge, a, b, sim::runs_along(mesh.triangles[a], edge) == sim::runs_along(mesh.triangles[b], edge)});
      std::erase(around, a);
      std::erase(around, b);
    }
  }
  return joints;
}

/// Turns triangles so that neighbours face the same side, as most of their sheet did; drops joints where that
/// cannot be.
void orient(sim::Mesh& mesh, std::vector<Joint>& joints) {
  std::vector<std::vector<std::size_t>> joints_of(mesh.triangles.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints_of[joints[j].a].push_back(j);
    joints_of[joints[j].b].push_back(j);
  }
  std::vector<char> turned(mesh.triangles.size(), 2);
  for (sim::Index first = 0; first < turned.size(); ++first) {
    std::vector<sim::Index> sheet;
    if (turned[first] == 2) {
      turned[first] = 0;
      sheet.push_back(first);
    }
    std::size_t turned_count = 0;
    for (std::size_t i = 0; i < sheet.size(); ++i) {
      turned_count += static_cast<std::size_t>(turned[sheet[i]]);
      for (const std::size_t j : joints_of[sheet[i]]) {
        const sim::Index other = joints[j].a == sheet[i] ? joints[j].b : joints[j].a;
        if (turned[other] == 2) {
          turned[other] = static_cast<char>(turned[sheet[i]] ^ static_cast<int>(joints[j].run_alike));
          sheet.push_back(other);
        }
      }
    }
    for (const sim::Index t : sheet) {
      turned[t] = static_cast<char>(turned[t] ^ static_cast<int>(2 * turned_count > sheet.size()));
    }
  }
  std::erase_if(joints, [&](const Joint& joint) { return (turned[joint.a] != turned[joint.b]) != joint.run_alike; });
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] == 1) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

sim::Index corner_at(const sim::Triangle& t, sim::Index vertex) { return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2; }

/// The corner from which the triangle's side along this edge begins.
sim::Index side_at(const std::vector<sim::Triangle>& triangles, sim::Index t, const sim::Edge& edge) {
  return 3 * t + corner_at(triangles[t], edge[sim::runs_along(triangles[t], edge) ? 0 : 1]);
}

/// Splits every vertex into one for each fan of triangles that stay together.
Sheets cut_between(const sim::Mesh& mesh, const std::vector<Joint>& joints) {
  Sheets sheets{{{}, mesh.triangles, {}}, std::vector<sim::Index>(mesh.triangles.size()), 0, {}};
  std::vector<sim::Triangle>& triangles = sheets.mesh.triangles;
  sim::Groups fans(3 * triangles.size()), parts(triangles.size());
  sheets.beyond.assign(3 * triangles.size(), sim::no_vertex);
  for (const Joint& joint : joints) {
    parts.join(joint.a, joint.b);
    sheets.beyond[side_at(triangles, joint.a, joint.edge)] = joint.b;
    sheets.beyond[side_at(triangles, joint.b, joint.edge)] = joint.a;
    for (const sim::Index v : joint.edge) {
      fans.join(3 * joint.a + corner_at(triangles[joint.a], v), 3 * joint.b + corner_at(triangles[joint.b], v));
    }
  }
  std::vector<sim::Index> vertex_of_fan(3 * triangles.size(), sim::no_vertex);
  std::vector<sim::Index> number(triangles.size(), sim::no_vertex);
  for (sim::Index c = 0; c < 3 * triangles.size(); ++c) {
    sim::Index& vertex = vertex_of_fan[fans.find(c)];
    if (vertex == sim::no_vertex) {
      vertex = static_cast<sim::Index>(sheets.mesh.positions.size());
      sheets.mesh.positions.push_back(mesh.positions[mesh.triangles[c / 3][c % 3]]);
    }
    triangles[c / 3][c % 3] = vertex;
    sim::Index& sheet = number[parts.find(c / 3)];
    sheet = sheet == sim::no_vertex ? sheets.count++ : sheet;
    sheets.sheet_of[c / 3] = sheet;
  }
  return sheets;
}

/// Marks triangles at edges that have more than two, those that go on across them apart; empty if there are
/// none.
std::vector<char> too_many_at_edges(const Sheets& sheets) {
  const sim::Adjacency adjacency = sim::make_adjacency(sheets.mesh);
  std::vector<char> marked;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto around = adjacency.edge_triangles[e];
    for (std::size_t i = 0; i < around.size() && around.size() > 2; ++i) {
      marked.resize(sheets.mesh.triangles.size());
      const sim::Index side = side_at(sheets.mesh.triangles, around[i], adjacency.edges[e]);
      marked[around[i]] |= static_cast<char>(sheets.beyond[side] == sim::no_vertex || i > 1);
    }
  }
  return marked;
}

}  // namespace

Sheets cut_into_sheets(const sim::Mesh& mesh) {
  sim::Mesh oriented{mesh.positions, mesh.triangles, {}};
  std::vector<Joint> joints = choose_joints(mesh);
  orient(oriented, joints);
  Sheets sheets = cut_between(oriented, joints);
  // A sheet can come back to an edge on a long way around.
  for (std::vector<char> apart = too_many_at_edges(sheets); !apart.empty(); apart = too_many_at_edges(sheets)) {
    std::erase_if(joints, [&](const Joint& joint) { return apart[joint.a] != 0 || apart[joint.b] != 0; });
    sheets = cut_between(oriented, joints);
  }
  return sheets;
}

std::vector<sim::Vec3> unit_normals(const sim::Mesh& mesh) {
  std::vector<sim::Vec3> normals;
  for (const sim::Triangle& t : mesh.triangles) {
    const sim::Vec3 normal = sim::doubled_area_vector(mesh.positions, t);
    const double length = glm::length(normal);
    normals.push_back(length > 0.0 ? normal / length : sim::Vec3(0.0));
  }
  return normals;
}

}  // namespace taut::app
