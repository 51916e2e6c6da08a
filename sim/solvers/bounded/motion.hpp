#pragma once

#include <vector>

#include "sim/solvers/bounded/kernels/lanes.hpp"

namespace taut::sim::bounded {

/// Where the cloth is within a frame: displacements since the frame's start in single precision. Absolute
/// positions would round away the motion of cloth that is nearly at rest, and never let it come to rest.
struct Motion {
  std::vector<Vec3> start_m;  ///< positions when the frame began, by row
  StartRows start;            ///< the same, for kernels
  Float4Array current;        ///< displacements now
  Float4Array previous;       ///< and one time step ago
};

}  // namespace taut::sim::bounded
