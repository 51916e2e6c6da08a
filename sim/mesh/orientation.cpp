#include "sim/mesh/orientation.hpp"

#include <utility>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::sim {
namespace {

struct Neighbour {
  Index triangle;
  bool disagrees;
};

/// Returns the triangles across the edges of each triangle, three entries per triangle. An entry that names
/// the triangle itself stands for no neighbour.
std::vector<Neighbour> neighbours_of(const Mesh& mesh) {
  const Adjacency adjacency = make_adjacency(mesh);
  std::vector<Neighbour> neighbours;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    neighbours.insert(neighbours.end(), 3, {t, false});
  }
  std::vector<char> filled(mesh.triangles.size(), 0);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto pair = adjacency.edge_triangles[e];
    if (pair.size() == 2) {
      const bool disagrees = runs_along(mesh.triangles[pair[0]], adjacency.edges[e]) ==
                             runs_along(mesh.triangles[pair[1]], adjacency.edges[e]);
      neighbours[3 * pair[0] + filled[pair[0]]++] = {pair[1], disagrees};
      neighbours[3 * pair[1] + filled[pair[1]]++] = {pair[0], disagrees};
    }
  }
  return neighbours;
}

}  // namespace

std::size_t orient_consistently(Mesh& mesh) {
  const std::vector<Neighbour> neighbours = neighbours_of(mesh);
  std::vector<char> reached(mesh.triangles.size(), 0), turned(mesh.triangles.size(), 0);
  std::size_t count = 0;
  std::vector<Index> part;
  for (Index seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (reached[seed]) {
      continue;
    }
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
