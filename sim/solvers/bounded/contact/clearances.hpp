#pragma once

#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// Finds the distances of vertices from near primitives that share none of their triangles' vertices: other layers of
/// the cloth, and bodies.
class Clearances {
 public:
  /// `cloth` and `bodies` are triangles by entry of `positions_m`, with no common entries. Pairs within the cloth count
  /// only if `within_cloth`.
  Clearances(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
             std::span<const Vec3> positions_m);

  /// Returns for each entry the smallest distance of its pairs (vertex and triangle, or two edges) in m, or `max_m`
  /// if that is smaller. Valid until the next call.
  std::span<const float> find(std::span<const Vec3> positions_m, float max_m);

 private:
  NearPairs near_;
  ParallelKernels kernels_;
  Float4Array rows_;
  Float4Array moves_;
  std::vector<float> radii_;
  std::vector<float> clearances_m_;
};

}  // namespace taut::sim::bounded
