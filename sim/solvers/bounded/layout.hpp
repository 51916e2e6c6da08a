#pragma once

#include <span>
#include <vector>

#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"

namespace taut::sim::bounded {

/// A garment as the solver wants it: one row for each vertex, in the order of the distance from the pins
/// along the cloth, which keeps rows that work together near each other; the pins are the first rows.
struct Layout {
  std::vector<Index> vertex_of_row;
  std::vector<Index> row_of_vertex;
  std::vector<float> inverse_masses_per_kg;  ///< by row; 0 for spare rows
  std::vector<double>
      distance_from_pins_m;            ///< by row, along the cloth; infinite where no pin can be reached
  std::vector<Index> nearest_pin_row;  ///< by row; 0 where no pin can be reached
  std::size_t pin_count = 0;
  SpringLanes springs;
  TriangleLanes triangles;
  double reach_m = 0.0;        ///< the largest distance from the pins
  double reach_springs = 0.0;  ///< the same counted in springs of mean length

  std::size_t vertex_count() const { return vertex_of_row.size(); }
  /// Vertices and the spare rows of padding lanes, whole blocks.
  std::size_t row_count() const { return (vertex_count() + 3 * block_size - 1) / block_size * block_size; }
};

Layout make_layout(const Garment& garment, const Pins& pins);

/// From positions by vertex, in m.
void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start);

}  // namespace taut::sim::bounded
