#pragma once

#include <mutex>

#include "app/fitting/following.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// Keeps the offsets of a model that follows a simulation mesh out of the mesh's next layer.
class OffsetLimits {
 public:
  OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated);

  /// Returns per bond the share of its offset that is left at these positions, in m: 1 where no other layer is
  /// nearer than the offsets of both together, or nearer than it was at rest; else so much that they just meet.
  /// Takes the bonds and triangles that it was made for. Threads may call it at the same time.
  std::vector<float> shares(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                            std::span<const sim::Triangle> triangles) const;

 private:
  std::vector<float> reach_m_;  ///< the largest offset of a bond about the vertex
  std::vector<float> at_rest_;  ///< of each share, by which it is divided
  mutable std::mutex mutex_;
  mutable sim::bounded::Clearances clearances_;  ///< whose searches use memory of their own
};

}  // namespace taut::app
