#pragma once

#include <vector>

#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// A mesh and its predicted motion. Solver indices are vertex indices.
struct Scene {
  std::vector<Triangle> cloth;
  std::vector<Triangle> bodies;
  Float4Array positions;
  Float4Array moves;
  std::vector<float> radii;
  /// The common motion that boxes leave out of all moves; see NearPairs.
  Float4 together = {};

  ContactMesh mesh() const { return make_contact_mesh(cloth, bodies); }
  std::vector<NearPair> find(VectorUnit unit = VectorUnit::best, int threads = 1) const {
    ParallelKernels kernels(kernels_for(unit), threads);
    return NearPairs(mesh(), true, places_m()).find(positions, moves, radii, kernels);
  }
  std::vector<Vec3> places_m() const {
    std::vector<Vec3> places;
    for (const Float4& p : positions) {
      places.push_back(to_vec3(p));
    }
    return places;
  }
};

/// The smallest distance of a pair on its path, along the line between its nearest points at the start.
struct Gap {
  double gap_m;
  double reach_m;  ///< sum of the two radii
  /// The error in single precision; the line between nearly touching primitives is also uncertain.
  double tolerance_m;
};

/// Calculates in double precision.
Gap measure_gap(const NearPair& pair, const Scene& scene);

/// Returns whether the boxes around all that each of the two can reach beyond `together` overlap, or are no further
/// apart than `room_m`.
bool boxes_overlap(const NearPair& pair, const Scene& scene, double room_m = 0.0);

/// Returns all pairs without a common vertex, except those within the bodies.
std::vector<NearPair> all_pairs(const ContactMesh& mesh);

}  // namespace taut::sim::bounded
