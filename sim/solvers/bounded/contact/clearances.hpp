#pragma once

#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// How far vertices are from what is near them and shares none of their triangles' vertices: other layers of
/// the cloth, and bodies.
class Clearances {
 public:
  /// `cloth` and `bodies` are triangles of rows; no row is of both. `positions_m` has one entry per row.
  /// Pairs within the cloth count only if asked for.
  Clearances(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
             std::span<const Vec3> positions_m);

  /// Returns for each row the smallest distance of a pair it has a part in, of a vertex and a triangle or of
  /// two edges, in m, at most `most_m`. Valid until the next call.
  std::span<const float> find(std::span<const Vec3> positions_m, float most_m);

  /// Returns for each row the smallest ratio of distance to reach of the pairs it has a part in, at most 1. The
  /// reach of a pair is the largest `reach_m` of the rows of its one thing plus that of its other, in m. Valid
  /// until the next call.
  std::span<const float> find_shares(std::span<const Vec3> positions_m, std::span<const float> reach_m);

 private:
  const std::vector<NearPair>& pairs_within(std::span<const Vec3> positions_m, std::span<const float> radii_m);
  float distance_of(const NearPair& pair) const;

  NearPairs near_;
  ParallelKernels kernels_;
  Float4Array rows_;
  Float4Array moves_;
  std::vector<float> radii_;
  std::vector<float> clearances_m_;
  std::vector<float> shares_;
};

}  // namespace taut::sim::bounded
