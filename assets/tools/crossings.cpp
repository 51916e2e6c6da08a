#include "tailor/crossings.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

namespace taut::tailor {
namespace {

using sim::Edge;
using sim::Index;
using sim::Mesh;
using sim::Triangle;
using sim::Vec3;

using Cell = std::array<int, 3>;

Cell cell_of(const Vec3& p, double cell_m) {
  const Vec3 cell = glm::floor(p / cell_m);
  return {static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)};
}

/// Calls visit(cell) for every cell of the box around the points.
template <typename Visit>
void for_each_cell(const Vec3& low_m, const Vec3& high_m, double cell_m, const Visit& visit) {
  const Cell low = cell_of(low_m, cell_m);
  const Cell high = cell_of(high_m, cell_m);
  for (int x = low[0]; x <= high[0]; ++x) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int z = low[2]; z <= high[2]; ++z) {
        visit(Cell{x, y, z});
      }
    }
  }
}

/// Moeller and Trumbore 1997, for a segment.
bool passes_through(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 along = to - from;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 normal = glm::cross(along, ac);
  const double determinant = glm::dot(ab, normal);
  if (determinant == 0.0) {
    return false;
  }
  const Vec3 offset = from - a;
  const double u = glm::dot(offset, normal) / determinant;
  const Vec3 across = glm::cross(offset, ab);
  const double v = glm::dot(along, across) / determinant;
  const double t = glm::dot(ac, across) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= 1.0;
}

bool touches(const Triangle& t, const Edge& edge) {
  return std::any_of(t.begin(), t.end(), [&](Index v) { return v == edge[0] || v == edge[1]; });
}

double longest_edge(const Mesh& mesh, const sim::Adjacency& adjacency) {
  double longest_m = 0.0;
  for (const auto& [a, b] : adjacency.edges) {
    longest_m = std::max(longest_m, glm::length(mesh.positions[a] - mesh.positions[b]));
  }
  return longest_m;
}

}  // namespace

std::size_t count_crossings(const Mesh& mesh, const sim::Adjacency& adjacency) {
  const auto& p = mesh.positions;
  const double cell_m = longest_edge(mesh, adjacency);
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    for_each_cell(glm::min(p[a], glm::min(p[b], p[c])), glm::max(p[a], glm::max(p[b], p[c])), cell_m,
                  [&](const Cell& cell) { cells[cell].push_back(i); });
  }
  std::size_t count = 0;
  for (const Edge& edge : adjacency.edges) {
    std::vector<std::size_t> near;
    const Vec3 &from = p[edge[0]], &to = p[edge[1]];
    for_each_cell(glm::min(from, to), glm::max(from, to), cell_m, [&](const Cell& cell) {
      const auto found = cells.find(cell);
      if (found != cells.end()) {
        near.insert(near.end(), found->second.begin(), found->second.end());
      }
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::size_t i : near) {
      const Triangle& t = mesh.triangles[i];
      count += !touches(t, edge) && passes_through(from, to, p[t[0]], p[t[1]], p[t[2]]) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace taut::tailor
