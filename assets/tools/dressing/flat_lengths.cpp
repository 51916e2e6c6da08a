#include "tailor/dressing/flat_lengths.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace taut::tailor {
namespace {

using sim::Edge;

Edge edge_between(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

struct FlatEdge {
  Edge ends;
  double length_m;
};

/// Of one panel, every edge once.
std::vector<FlatEdge> flat_edges(const Panel& panel) {
  std::vector<Edge> point_pairs;
  for (const Triangle& t : panel.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      point_pairs.push_back(edge_between(t[k], t[(k + 1) % 3]));
    }
  }
  std::sort(point_pairs.begin(), point_pairs.end());
  point_pairs.erase(std::unique(point_pairs.begin(), point_pairs.end()), point_pairs.end());
  std::vector<FlatEdge> edges;
  for (const auto& [a, b] : point_pairs) {
    edges.push_back(
        {edge_between(panel.vertices[a], panel.vertices[b]), glm::length(panel.flat_m[a] - panel.flat_m[b])});
  }
  return edges;
}

using Lengths = std::map<Edge, double>;

Lengths mean_flat_lengths(const Shirt& shirt) {
  std::map<Edge, std::pair<double, int>> sums;
  for (const Panel& panel : shirt.panels) {
    for (const FlatEdge& edge : flat_edges(panel)) {
      sums[edge.ends].first += edge.length_m;
      ++sums[edge.ends].second;
    }
  }
  Lengths lengths;
  for (const auto& [ends, sum] : sums) {
    lengths[ends] = sum.first / sum.second;
  }
  return lengths;
}

/// Where the third corner of a triangle lies when its side of length `base` is put on the x axis; y >= 0.
Vec2 laid_out(double base_m, double from_start_m, double from_end_m) {
  const double x = (from_start_m * from_start_m + base_m * base_m - from_end_m * from_end_m) / (2.0 * base_m);
  return {x, std::sqrt(std::max(0.0, from_start_m * from_start_m - x * x))};
}

Index corner_opposite(const Triangle& t, const Edge& edge) {
  return *std::find_if(t.begin(), t.end(), [&](Index v) { return v != edge[0] && v != edge[1]; });
}

/// For the two vertices opposite each interior edge, their distance once the triangles are unfolded.
Lengths unfolded_lengths(const sim::Garment& garment, const Lengths& flat) {
  Lengths unfolded;
  const sim::Adjacency& adjacency = garment.adjacency;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto triangles = adjacency.edge_triangles[e];
    if (triangles.size() != 2) {
      continue;
    }
    const Edge& edge = adjacency.edges[e];
    const Index a = corner_opposite(garment.mesh.triangles[triangles[0]], edge);
    const Index b = corner_opposite(garment.mesh.triangles[triangles[1]], edge);
    const double base_m = flat.at(edge);
    const auto lay_out = [&](Index v) {
      return laid_out(base_m, flat.at(edge_between(v, edge[0])), flat.at(edge_between(v, edge[1])));
    };
    const Vec2 at_a = lay_out(a);
    const Vec2 at_b = lay_out(b);
    unfolded.emplace(edge_between(a, b), glm::length(at_a - Vec2(at_b.x, -at_b.y)));
  }
  return unfolded;
}

}  // namespace

Strain measure_strain(const Shirt& shirt, const std::vector<Vec3>& positions) {
  assert(positions.size() == shirt.vertex_count);
  double sum_of_squares = 0.0;
  double worst = 0.0;
  std::size_t count = 0;
  for (const Panel& panel : shirt.panels) {
    for (const auto& [ends, flat_m] : flat_edges(panel)) {
      const double strain = glm::length(positions[ends[0]] - positions[ends[1]]) / flat_m - 1.0;
      sum_of_squares += strain * strain;
      worst = std::max(worst, std::abs(strain));
      ++count;
    }
  }
  return {std::sqrt(sum_of_squares / static_cast<double>(count)), worst};
}

sim::Garment make_flat_garment(const Shirt& shirt, const std::vector<Vec3>& positions) {
  assert(positions.size() == shirt.vertex_count);
  const sim::MappingSettings mapping = {.flexural_rule = sim::FlexuralRule::opposite_vertex};
  sim::Garment garment =
      sim::make_garment({positions, shirt.triangles(), {}}, mapping, {.thickness_m = 0.002});
  const Lengths flat = mean_flat_lengths(shirt);
  const Lengths unfolded = unfolded_lengths(garment, flat);
  sim::Springs& springs = garment.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const bool is_structural = s < springs.structural_count;
    springs.rest_lengths_m[s] = (is_structural ? flat : unfolded).at(springs.ends[s]);
  }
  return garment;
}

}  // namespace taut::tailor
