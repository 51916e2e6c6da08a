#pragma once

#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/settings.hpp"

namespace taut::sim::bounded {

/// Vertices of a garment in solver order. The solver index of a vertex is called "row" in names. Vertices are sorted by
/// their distance from the pins along the cloth, so that vertices used together lie close together in memory. The pins
/// come first. Arrays by solver index have one entry per vertex unless said otherwise.
struct SolverOrder {
  std::vector<Index> vertex_indices;
  std::vector<Index> solver_indices;
  /// Inverse masses by solver index, including padding, where they are 0.
  std::vector<float> inverse_masses_per_kg;
  std::vector<double> distance_from_pins_m;  ///< lengths along the cloth; infinite if no pin can be reached
  std::vector<Index> nearest_pin_row;        ///< nearest pin by solver index; 0 if no pin can be reached
  std::size_t pin_count = 0;
  /// Largest finite distance from the pins.
  double reach_m = 0.0;
  /// Largest distance from the pins, in springs of mean length.
  double reach_springs = 0.0;

  /// Returns the number of solver indices without padding.
  std::size_t vertex_count() const { return vertex_indices.size(); }
  /// Returns the number of vertices plus padding, rounded up to whole blocks.
  std::size_t row_count() const;
};

/// Requires the pins of this garment.
SolverOrder make_rows(const Garment& garment, const Pins& pins);

/// Returns the inverse projection weight of vertex i divided by the weight of vertex j, for equal masses. Weights grow
/// towards the pins.
double projection_ratio(Index row_i, Index row_j, const SolverOrder& rows);

/// Garment data in solver order.
struct Layout : SolverOrder {
  /// Bounded springs and triangles: either all springs, or all triangles and the springs that no triangle bounds.
  SpringLanes springs;
  SurfaceLanes surface;
  TriangleLanes triangles;  ///< all triangles, for the wind
};

/// Requires the pins of this garment.
Layout make_layout(const Garment& garment, const Pins& pins, BoundKind bound = BoundKind::springs);

/// Sets `start` to these positions, in m, one per vertex. The vertex with the first solver index becomes the origin.
void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start);

/// Returns, per spring of the garment, whether a bound on its triangles bounds it too. This holds for the edges of
/// triangles that have a surface, and for the diagonals of flat cells of such triangles.
std::vector<bool> springs_held_by_triangles(const Garment& garment);

/// Returns the triangles that have a surface and a movable corner.
SurfaceLanes make_surface_lanes(const Garment& garment, const Pins& pins, const SolverOrder& rows);

}  // namespace taut::sim::bounded
