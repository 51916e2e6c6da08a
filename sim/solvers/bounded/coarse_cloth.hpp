#pragma once

#include <vector>

#include "sim/garment.hpp"

namespace taut::sim::bounded {

/// A garment seen from further away: clusters of about four vertices each, with the mass of all of them at
/// their centre of mass, and triangles where three clusters meet.
struct CoarseCloth {
  Garment garment;
  std::vector<Index> cluster_of;     ///< by vertex of the finer garment
  std::vector<double> part_of_mass;  ///< of its cluster's, by vertex of the finer garment
};

/// Clusters are begun at the vertices of the finer garment in the given `order`, and grow along its edges.
CoarseCloth coarsen(const Garment& fine, const std::vector<Index>& order);

}  // namespace taut::sim::bounded
