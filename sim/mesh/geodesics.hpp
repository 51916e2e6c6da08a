#pragma once

#include "sim/mesh/adjacency.hpp"

namespace taut::sim {

/// Distances along the cloth, one entry per vertex. A vertex beyond reach of all sources has an infinite distance and
/// `no_source`.
struct GeodesicDistances {
  static constexpr Index no_source = ~Index{0};

  std::vector<double> distances_m;
  std::vector<Index> nearest_sources;
};

/// Returns the distance of every vertex from the nearest of `sources` along the cloth. Requires sources below the
/// number of vertices and the adjacency of this mesh.
///
/// The distances spread from triangle to triangle as a front (Kimmel and Sethian 1998). The distances at two corners of
/// a triangle give the position of the source in the unfolded plane, and that gives the third corner's distance. The
/// result is exact on flat cloth in sight of one source, and slightly too long elsewhere.
GeodesicDistances geodesic_distances(const Mesh& mesh, const Adjacency& adjacency, std::span<const Index> sources);

}  // namespace taut::sim
