#pragma once

#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// One entry per vertex. A vertex that no source can reach has an infinite distance and `no_source`.
struct GeodesicDistances {
  static constexpr Index no_source = ~Index{0};

  std::vector<double> distances_m;
  std::vector<Index> nearest_sources;
};

/// Returns how far every vertex is from the nearest of `sources` along the cloth of `mesh`. Requires sources
/// below the number of vertices and the adjacency of this mesh.
///
/// The distances spread from triangle to triangle as a front (Kimmel and Sethian 1998). Two known corners of
/// a triangle and their distances give the place of the source in the unfolded plane. The third corner's
/// distance is measured from that place. The result is exact on flat cloth in sight of one source, and
/// slightly too long elsewhere.
GeodesicDistances geodesic_distances(const Mesh& mesh, const Adjacency& adjacency, std::span<const Index> sources);

}  // namespace taut::sim
