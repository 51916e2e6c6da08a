#pragma once

#include <random>

#include "sim/mesh/grid.hpp"

namespace taut::sim {

/// Returns a square grid of count x count vertices; count must be at least 2.
inline Mesh sheet(Index count, double size_m) {
  GridSettings grid;
  grid.columns = grid.rows = count;
  grid.width_m = grid.height_m = size_m;
  return make_grid(grid);
}

/// Returns the same sheet without grid cells, its vertices moved at random by up to a fifth of a cell. The
/// seed is fixed.
inline Mesh irregular_sheet(Index count, double size_m) {
  Mesh mesh = sheet(count, size_m);
  mesh.quads.clear();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-0.2, 0.2);
  const double cell_m = size_m / (count - 1);
  for (Vec3& p : mesh.positions) {
    p.x += cell_m * offset(random);
    p.y += cell_m * offset(random);
  }
  return mesh;
}

}  // namespace taut::sim
