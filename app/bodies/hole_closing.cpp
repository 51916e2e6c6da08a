#include "app/bodies/hole_closing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using Loop = std::vector<sim::Index>;

/// Per vertex of a border the one that follows along it; no_vertex where borders touch.
std::map<sim::Index, sim::Index> border_successors(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  std::map<sim::Index, sim::Index> next;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() != 1) {
      continue;
    }
    const sim::Edge& edge = adjacency.edges[e];
    const bool along = sim::runs_along(mesh.triangles[adjacency.edge_triangles[e][0]], edge);
    const auto [place, is_first] = next.emplace(edge[along ? 0 : 1], edge[along ? 1 : 0]);
    if (!is_first) {
      place->second = sim::no_vertex;
    }
  }
  return next;
}

/// Takes the loop that begins at the first vertex out of `next`; empty if it does not close.
Loop take_loop(std::map<sim::Index, sim::Index>& next) {
  const sim::Index begin = next.begin()->first;
  Loop loop;
  for (sim::Index at = begin;;) {
    const auto found = next.find(at);
    if (found == next.end() || found->second == sim::no_vertex) {
      next.erase(begin);
      return {};
    }
    loop.push_back(at);
    at = found->second;
    next.erase(found);
    if (at == begin) {
      return loop;
    }
  }
}

double length_around(const sim::Mesh& mesh, const Loop& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += glm::distance(mesh.positions[loop[i]], mesh.positions[loop[(i + 1) % loop.size()]]);
  }
  return length;
}

/// The triangles of the fan from one vertex of the loop, turned against the border.
std::vector<sim::Triangle> fan_from(std::size_t apex, const Loop& loop) {
  std::vector<sim::Triangle> fan;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    fan.push_back({loop[apex], loop[(apex + k + 1) % loop.size()], loop[(apex + k) % loop.size()]});
  }
  return fan;
}

bool has_edge_from(sim::Index vertex, const Loop& loop, const sim::Adjacency& adjacency) {
  std::size_t shared = 0;
  for (const sim::Index e : adjacency.vertex_edges[vertex]) {
    const sim::Index other = sim::other_end(adjacency.edges[e], vertex);
    shared += std::find(loop.begin(), loop.end(), other) != loop.end() ? 1 : 0;
  }
  return shared > 2;  // besides the two of the border
}

double smallest_area(const sim::Mesh& mesh, std::span<const sim::Triangle> fan) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const sim::Triangle& t : fan) {
    smallest = std::min(smallest, glm::length(sim::doubled_area_vector(mesh.positions, t)));
  }
  return smallest;
}

std::vector<sim::Triangle> best_fan(const sim::Mesh& mesh, const sim::Adjacency& adjacency,
                                    const Loop& loop) {
  std::vector<sim::Triangle> best;
  double best_area = 0.0;
  for (std::size_t apex = 0; apex < loop.size(); ++apex) {
    if (!has_edge_from(loop[apex], loop, adjacency)) {
      std::vector<sim::Triangle> fan = fan_from(apex, loop);
      const double area = smallest_area(mesh, fan);
      if (area > best_area) {
        best_area = area;
        best = std::move(fan);
      }
    }
  }
  return best;
}

/// A triangle by itself has a border like a hole of three edges.
bool is_lone_triangle(const Loop& loop, const sim::Adjacency& adjacency) {
  return loop.size() == 3 && std::all_of(loop.begin(), loop.end(),
                                         [&](sim::Index v) { return adjacency.vertex_edges[v].size() == 2; });
}

}  // namespace

std::vector<ClosedHole> close_small_holes(double longest, sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  std::map<sim::Index, sim::Index> next = border_successors(mesh, adjacency);
  std::vector<ClosedHole> closed;
  while (!next.empty()) {
    const Loop loop = take_loop(next);
    const double around = length_around(mesh, loop);
    if (loop.size() < 3 || !(around <= longest) || is_lone_triangle(loop, adjacency)) {
      continue;
    }
    const std::vector<sim::Triangle> fan = best_fan(mesh, adjacency, loop);
    if (!fan.empty()) {
      mesh.triangles.insert(mesh.triangles.end(), fan.begin(), fan.end());
      closed.push_back({around, loop.front()});
    }
  }
  std::stable_sort(closed.begin(), closed.end(),
                   [](const ClosedHole& a, const ClosedHole& b) { return a.around > b.around; });
  return closed;
}

}  // namespace taut::app
