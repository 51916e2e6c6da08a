#pragma once

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::sim::bounded {

/// The vertices of a garment in the order that the solver works in: one row per vertex. Rows are sorted by
/// the distance from the pins along the cloth, so that rows used together lie close together. The pins are
/// the first rows. Arrays "by row" have one entry per vertex unless said otherwise.
struct Rows {
  std::vector<Index> vertex_of_row;
  std::vector<Index> row_of_vertex;
  /// By row, spare rows included, where it is 0.
  std::vector<float> inverse_masses_per_kg;
  std::vector<double> distance_from_pins_m;  ///< by row, along the cloth; infinite where no pin can be reached
  std::vector<Index> nearest_pin_row;        ///< by row; 0 where no pin can be reached
  std::size_t pin_count = 0;
  /// The largest finite distance from the pins.
  double reach_m = 0.0;
  /// The same distance in springs of mean length.
  double reach_springs = 0.0;

  /// Equal to the number of rows without the spare ones.
  std::size_t vertex_count() const { return vertex_of_row.size(); }
  /// The number of vertices plus the spare rows that padding uses, rounded up to whole blocks.
  std::size_t row_count() const;
};

/// Requires the pins of this garment.
Rows make_rows(const Garment& garment, const Pins& pins);

/// Returns the inverse weight of row i in the projection divided by that of row j, for equal masses. Weights
/// grow towards the pins.
double projection_ratio(Index row_i, Index row_j, const Rows& rows);

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

/// Returns, per spring of the garment, whether it keeps any bound on the stretch of its triangles by itself:
/// the edges of triangles that have a surface, and the diagonals of flat cells of such triangles.
std::vector<bool> springs_held_by_triangles(const Garment& garment);

/// Returns the triangles that have a surface and a corner that can move.
SurfaceLanes make_surface_lanes(const Garment& garment, const Pins& pins, const Rows& rows);

}  // namespace taut::sim::bounded
