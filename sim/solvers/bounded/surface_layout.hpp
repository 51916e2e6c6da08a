#pragma once

#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/rows.hpp"

namespace taut::sim::bounded {

/// Returns, per spring of the garment, whether it keeps any bound on the stretch of its triangles by itself:
/// the edges of triangles that have a surface, and the diagonals of flat cells of such triangles.
std::vector<bool> springs_held_by_triangles(const Garment& garment);

/// Returns the triangles that have a surface and a corner that can move.
SurfaceLanes make_surface_lanes(const Garment& garment, const Pins& pins, const Rows& rows);

}  // namespace taut::sim::bounded
