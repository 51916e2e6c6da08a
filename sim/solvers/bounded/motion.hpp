#pragma once

#include "sim/solvers/bounded/kernels/lanes.hpp"

namespace taut::sim::bounded {

/// Positions within a frame: single-precision displacements since the start of the frame, in m. Absolute positions in
/// single precision would round off the motion of cloth that is almost at rest, so that it would never come to rest.
struct Motion {
  std::vector<Vec3> start_m;  ///< positions at the start of the frame, by solver index
  StartRows start;            ///< start positions for kernels
  Float4Array current;        ///< current displacements
  Float4Array previous;       ///< displacements one time step ago
};

}  // namespace taut::sim::bounded
