#include "sim/springs.hpp"

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

constexpr double turns_per_radian = 0.15915494309189535;

Edge make_edge(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

void sort_and_deduplicate(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

std::vector<Edge> remove_edges(const std::vector<Edge>& edges, const std::vector<Edge>& sorted_unwanted) {
  std::vector<Edge> remaining_edges;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(remaining_edges),
               [&](const Edge& e) { return !std::binary_search(sorted_unwanted.begin(), sorted_unwanted.end(), e); });
  return remaining_edges;
}

std::vector<Edge> cell_diagonals(const Mesh& mesh) {
  std::vector<Edge> diagonals;
  diagonals.reserve(mesh.quads.size() * 2);
  for (const Quad& q : mesh.quads) {
    diagonals.push_back(make_edge(q[0], q[2]));
    diagonals.push_back(make_edge(q[1], q[3]));
  }
  sort_and_deduplicate(diagonals);
  return diagonals;
}

struct Neighbour {
  Index vertex;
  Vec3 direction;  ///< unit vector
};

/// Returns the neighbour in the direction closest to opposite of neighbour a's. Returns a itself if the angle to every
/// other neighbour is too small.
Index find_opposite_neighbour(const Neighbour& a, std::span<const Neighbour> neighbours, double max_cosine) {
  assert(std::abs(max_cosine) <= 1.0);
  Index best = a.vertex;
  double best_cosine = max_cosine;
  for (const Neighbour& b : neighbours) {
    if (b.vertex == a.vertex) continue;
    const double cosine = glm::dot(a.direction, b.direction);
    // The smaller index wins a tie: the order of the edges must not matter.
    if (cosine < best_cosine || (cosine == best_cosine && (best == a.vertex || b.vertex < best))) {
      best = b.vertex;
      best_cosine = cosine;
    }
  }
  return best;
}

std::vector<Edge> angular_pairs(const Mesh& mesh, const std::vector<Edge>& structural, double min_angle_rad) {
  const CompressedRows edges_at = at_vertices(mesh.positions.size(), structural);
  const double max_cosine = sine_of_turns(0.25 - min_angle_rad * turns_per_radian);
  std::vector<Edge> pairs;
  std::vector<Neighbour> neighbours;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    neighbours.clear();
    for (const Index e : edges_at[v]) {
      const Index other = other_end(structural[e], v);
      neighbours.push_back({other, glm::normalize(mesh.positions[other] - mesh.positions[v])});
    }
    for (const Neighbour& a : neighbours) {
      const Index b = find_opposite_neighbour(a, neighbours, max_cosine);
      if (b != a.vertex) pairs.push_back(make_edge(a.vertex, b));
    }
  }
  return pairs;
}

Index corner_opposite(const Triangle& t, const Edge& edge) {
  for (const Index v : t) {
    if (v != edge[0] && v != edge[1]) return v;
  }
  return t[0];
}

std::vector<Edge> opposite_vertex_pairs(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<Edge> pairs;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto triangles = adjacency.edge_triangles[e];
    if (triangles.size() != 2) continue;
    const Index a = corner_opposite(mesh.triangles[triangles[0]], adjacency.edges[e]);
    const Index b = corner_opposite(mesh.triangles[triangles[1]], adjacency.edges[e]);
    if (a != b) pairs.push_back(make_edge(a, b));
  }
  return pairs;
}

std::vector<Edge> flexural_pairs(const Mesh& mesh, const Adjacency& adjacency, const std::vector<Edge>& structural,
                                 const MappingSettings& settings) {
  if (settings.flexural_rule == FlexuralRule::none) return {};
  return settings.flexural_rule == FlexuralRule::opposite_vertex
             ? opposite_vertex_pairs(mesh, adjacency)
             : angular_pairs(mesh, structural, settings.min_flexural_angle_rad);
}

void append(Springs& springs, const std::vector<Edge>& ends, const std::vector<Vec3>& positions) {
  for (const Edge& e : ends) {
    springs.ends.push_back(e);
    springs.rest_lengths_m.push_back(glm::length(positions[e[0]] - positions[e[1]]));
  }
}

/// Sets rest lengths from the cut panels. Where the sides of a seam differ in length, the shorter one counts.
void shorten_to_panels(const Mesh& mesh, const Adjacency& adjacency, Springs& springs) {
  for (std::size_t s = 0; s < springs.structural_count; ++s) {
    const auto edge = std::lower_bound(adjacency.edges.begin(), adjacency.edges.end(), springs.ends[s]);
    const auto e = static_cast<std::size_t>(edge - adjacency.edges.begin());
    double& length_m = springs.rest_lengths_m[s];
    length_m = std::numeric_limits<double>::infinity();
    for (const Index t : adjacency.edge_triangles[e]) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (make_edge(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]) == springs.ends[s]) {
          length_m = std::min(length_m, glm::distance(mesh.cut_m[t][k], mesh.cut_m[t][(k + 1) % 3]));
        }
      }
    }
  }
}

}  // namespace

const char* to_name(SpringKind kind) {
  constexpr std::array names = {"structural", "shear", "flexural"};
  return names[static_cast<std::size_t>(kind)];
}

double mean_edge_m(const Springs& springs) {
  const auto begin = springs.rest_lengths_m.begin();
  const double sum_m = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(springs.structural_count), 0.0);
  return sum_m / static_cast<double>(std::max<std::size_t>(springs.structural_count, 1));
}

std::size_t Springs::begin_index(SpringKind kind) const {
  return std::array{std::size_t{0}, structural_count, structural_count + shear_count}[static_cast<std::size_t>(kind)];
}

std::size_t Springs::end_index(SpringKind kind) const {
  return std::array{structural_count, structural_count + shear_count, size()}[static_cast<std::size_t>(kind)];
}

Springs map_to_springs(const Mesh& mesh, const Adjacency& adjacency, const MappingSettings& settings) {
  const std::vector<Edge> shear = cell_diagonals(mesh);
  const std::vector<Edge> structural = remove_edges(adjacency.edges, shear);
  std::vector<Edge> flexural = flexural_pairs(mesh, adjacency, structural, settings);
  sort_and_deduplicate(flexural);
  // Two neighbours of a vertex can be joined already, in a small ring.
  flexural = remove_edges(remove_edges(flexural, structural), shear);

  Springs springs;
  append(springs, structural, mesh.positions);
  springs.structural_count = springs.size();
  append(springs, shear, mesh.positions);
  springs.shear_count = springs.size() - springs.structural_count;
  append(springs, flexural, mesh.positions);
  if (!mesh.cut_m.empty()) shorten_to_panels(mesh, adjacency, springs);
  return springs;
}

}  // namespace taut::sim
