#include "app/models/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

// Of the garment's size. A larger distance would hold the folds of a coarse model apart as if they were
// stuffed.
constexpr double largest_distance = 0.02;
// Of the garment's size. Cloth finer than this is a damaged model and has no layers.
constexpr double smallest_distance = 1e-4;
// Of the gap between parts. It must be below one half, or the parts count as one cloth.
constexpr double of_the_gap = 0.45;
// Of the length of edges. Parts closer than this touch and are not kept apart.
constexpr double smallest_gap = 0.1;
// Vertices in a cube as wide as the distance, for an average vertex. Even meshes have one or two. In a mesh
// that is dense in places, every vertex there would be compared with hundreds of its own layer.
constexpr double densest_crowd = 6.0;
// Factor on the distance while the cubes are too crowded.
constexpr double less_distance = 0.7;
// Limit on pairs of vertices that are compared, for some milliseconds. Above it some vertices are skipped.
constexpr std::size_t most_distances = 4'000'000;

double usual_edge(const sim::Garment& garment) {
  std::vector<double> lengths_m;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    lengths_m.push_back(glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]));
  }
  const auto middle = lengths_m.begin() + static_cast<std::ptrdiff_t>(lengths_m.size() / 2);
  std::nth_element(lengths_m.begin(), middle, lengths_m.end());
  return *middle;
}

double size_of(const sim::Mesh& mesh) {
  return glm::length(sim::extent_of(mesh.positions).size());
}

/// The vertices in a cube of this width that an average vertex is in, itself included.
double crowd_around(const std::vector<sim::Vec3>& positions, double width_m) {
  using Cell = std::array<std::int64_t, 3>;
  std::vector<Cell> cells;
  cells.reserve(positions.size());
  for (const sim::Vec3& p : positions) {
    const sim::Vec3 at = glm::floor(p / width_m);
    cells.push_back(
        {static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y), static_cast<std::int64_t>(at.z)});
  }
  std::sort(cells.begin(), cells.end());
  double squares = 0.0;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto next = std::find_if(first, cells.end(), [&](const Cell& cell) { return cell != *first; });
    squares += std::pow(static_cast<double>(next - first), 2.0);
    first = next;
  }
  return squares / static_cast<double>(positions.size());
}

/// The lower quartile of the distances from vertices to the nearest vertex of another part, among those
/// between `smallest_m` and `largest_m`; infinite where there are none.
double gap_between_parts(const sim::Garment& garment, double smallest_m, double largest_m) {
  const std::vector<sim::Vec3>& positions = garment.mesh.positions;
  sim::Groups parts(positions.size());
  for (const sim::Edge& edge : garment.adjacency.edges) {
    parts.join(edge[0], edge[1]);
  }
  std::vector<sim::Index> part_of(positions.size());
  for (sim::Index v = 0; v < positions.size(); ++v) {
    part_of[v] = parts.find(v);
  }
  if (std::all_of(part_of.begin(), part_of.end(), [&](sim::Index part) { return part == part_of[0]; })) {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<double> gaps_m;
  const std::size_t stride = 1 + positions.size() * positions.size() / most_distances;
  for (std::size_t v = 0; v < positions.size(); v += stride) {
    double squared = largest_m * largest_m;
    for (std::size_t other = 0; other < positions.size(); ++other) {
      const sim::Vec3 between = positions[v] - positions[other];
      if (part_of[v] != part_of[other]) {
        squared = std::min(squared, glm::dot(between, between));
      }
    }
    if (squared < largest_m * largest_m && squared > smallest_m * smallest_m) {
      gaps_m.push_back(std::sqrt(squared));
    }
  }
  if (gaps_m.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  const auto quartile = gaps_m.begin() + static_cast<std::ptrdiff_t>(gaps_m.size() / 4);
  std::nth_element(gaps_m.begin(), quartile, gaps_m.end());
  return *quartile;
}

}  // namespace

double suitable_layer_distance(const sim::Garment& garment) {
  const double edge_m = usual_edge(garment);
  const double size_m = size_of(garment.mesh);
  const double distance_m = std::min(edge_m, largest_distance * size_m);
  const double gap_m = gap_between_parts(garment, smallest_gap * edge_m, distance_m / of_the_gap);
  const double smallest_m = smallest_distance * size_m;
  double suitable_m = std::min(distance_m, of_the_gap * gap_m);
  while (suitable_m >= smallest_m && crowd_around(garment.mesh.positions, suitable_m) > densest_crowd) {
    suitable_m *= less_distance;
  }
  return suitable_m < smallest_m ? 0.0 : suitable_m;
}

}  // namespace taut::app
