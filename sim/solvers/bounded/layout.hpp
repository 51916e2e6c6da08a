#pragma once

#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/rows.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::sim::bounded {

/// A garment as the solver works on it.
struct Layout : Rows {
  /// The springs and triangles that keep the bound: all springs, or all triangles and the springs that no triangle
  /// holds.
  SpringLanes springs;
  SurfaceLanes surface;
  TriangleLanes triangles;  ///< for the wind
};

/// Requires the pins of this garment.
Layout make_layout(const Garment& garment, const Pins& pins, BoundKind bound = BoundKind::springs);

/// Sets `start` to these positions, in m, one per vertex. The first row's vertex becomes the origin.
void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start);

}  // namespace taut::sim::bounded
