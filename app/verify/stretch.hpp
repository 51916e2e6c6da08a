#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Largest ratios of lengths now to lengths at rest, minus 1; -1 if nothing is measured.
struct LargestStretch {
  double springs = -1.0;  ///< edges of triangles and both diagonals of grid cells
  /// Stretch in any direction of any triangle. Triangles thinner at rest than a thousandth of their longest edge are
  /// measured by springs alone.
  double surface = -1.0;
};

/// Measures the mesh at these positions, in metres, one per vertex. Requires a triangle. Only lengths are used: the
/// singular values of a triangle's deformation are the square roots of the eigenvalues of its present first fundamental
/// form relative to its form at rest.
LargestStretch largest_stretch(const sim::Mesh& rest, std::span<const sim::Vec3> positions_m);

}  // namespace taut::app
