#pragma once

#include "sim/garment.hpp"

namespace taut::sim::bounded {

/// Vertices of the largest cluster: edges twice as long.
inline constexpr std::size_t largest_cluster = 4;

/// A coarser copy of a garment: clusters of about four vertices each. A cluster has the mass of all its
/// vertices at their centre of mass. Triangles are where three clusters meet.
struct CoarseCloth {
  Garment garment;
  std::vector<Index> cluster_of;  ///< per vertex of the finer garment
  /// The vertex's fraction of the mass of its cluster; per vertex of the finer garment.
  std::vector<double> mass_fraction;
};

/// Groups the vertices of the finer garment into clusters. Clusters start at its vertices in the given
/// `order`, which names each vertex once, and grow along its edges.
CoarseCloth coarsen(const Garment& fine, const std::vector<Index>& order);

}  // namespace taut::sim::bounded
