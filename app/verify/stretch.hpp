#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Lengths now / lengths at rest - 1, the largest; -1 where there is nothing to measure.
struct LargestStretch {
  double springs = -1.0;  ///< of the edges of triangles and both diagonals of grid cells
  /// Of any direction in any triangle. Those thinner at rest than a thousandth of their longest edge are left
  /// to the springs.
  double surface = -1.0;
};

/// Measures the mesh in these positions, in metres, one per vertex. Requires a triangle. From lengths alone:
/// the singular values of a triangle's deformation are the square roots of the eigenvalues of its first
/// fundamental form now by that at rest.
LargestStretch largest_stretch(const sim::Mesh& rest, std::span<const sim::Vec3> positions_m);

}  // namespace taut::app
