#pragma once

#include <span>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// By vertex. Infinite, and no source, where none can be reached.
struct GeodesicDistances {
  static constexpr Index no_source = ~Index{0};

  std::vector<double> distances_m;
  std::vector<Index> nearest_sources;
};

/// How far every vertex is from the nearest of `sources`, along the cloth as `mesh` has it.
///
/// Distances go from triangle to triangle as a front (Kimmel and Sethian 1998): two known corners and their
/// distances say where the source would lie if the cloth between were unfolded, and the third corner is as
/// far as it is from there. Exact on flat cloth in the sight of one source; elsewhere a little too long.
GeodesicDistances geodesic_distances(const Mesh& mesh, const Adjacency& adjacency,
                                     std::span<const Index> sources);

}  // namespace taut::sim
