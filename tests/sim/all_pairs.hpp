#pragma once

#include <vector>

#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// A mesh on its way. Rows are vertices.
struct Scene {
  std::vector<Triangle> cloth;
  std::vector<Triangle> bodies;
  Float4Array positions;
  Float4Array moves;
  std::vector<float> radii;
  /// The move that boxes leave out of all; see NearPairs.
  Float4 together = {};

  ContactMesh mesh() const { return make_contact_mesh(cloth, bodies); }
  std::vector<NearPair> find(VectorUnit unit = VectorUnit::best, int threads = 1) const {
    ParallelKernels kernels(kernels_for(unit), threads);
    return NearPairs(mesh(), true, places_m()).find(positions, moves, radii, kernels);
  }
  std::vector<Vec3> places_m() const {
    std::vector<Vec3> places;
    for (const Float4& p : positions) {
      places.push_back(vector_of(p));
    }
    return places;
  }
};

/// How far a pair stays apart on its way, along the line between its nearest points.
struct Gap {
  double gap_m;
  double reach_m;  ///< what both may move besides
  /// Of single precision, in which the line between what nearly touches is uncertain too.
  double tolerance_m;
};

/// In double precision.
Gap gap_of(const NearPair& pair, const Scene& scene);

/// Returns whether the boxes around all that each of the two can reach beyond `together` overlap, or are no further
/// apart than `room_m`.
bool boxes_overlap(const NearPair& pair, const Scene& scene, double room_m = 0.0);

/// All pairs that share no row, apart from those within the bodies.
std::vector<NearPair> all_pairs(const ContactMesh& mesh);

}  // namespace taut::sim::bounded
