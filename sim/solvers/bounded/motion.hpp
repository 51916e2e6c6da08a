#pragma once

#include "sim/solvers/bounded/kernels/lanes.hpp"

namespace taut::sim::bounded {

/// Where the cloth is within a frame: single-precision displacements since the start of the frame, in m.
/// Absolute positions in single precision would round off the motion of cloth that is almost at rest, so that
/// it would never come to rest.
struct Motion {
  std::vector<Vec3> start_m;  ///< positions at the start of the frame, one per vertex, by row
  StartRows start;            ///< the same for kernels
  Float4Array current;        ///< displacements now
  Float4Array previous;       ///< displacements one time step ago
};

}  // namespace taut::sim::bounded
