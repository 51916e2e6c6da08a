#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Plane of a grid.
enum class GridPlane {
  vertical,    ///< xy plane, facing +z, row 0 at the top
  horizontal,  ///< xz plane, facing +y, row 0 at the back (the smallest z)
};

/// Settings of a regular m x n mass-spring cloth (the paper's Figure 1).
struct GridSettings {
  Index columns = 9;  ///< mass points across, at least 2
  Index rows = 9;     ///< mass points down, at least 2
  double width_m = 1.0;
  double height_m = 1.0;
  GridPlane plane = GridPlane::vertical;
  Vec3 top_centre_m = {0.0, 0.0, 0.0};  ///< middle of row 0
};

/// Returns a grid whose vertex r * columns + c is in row r and column c. Column 0 has the smallest x. Throws
/// std::invalid_argument on fewer than two rows or columns, and on a width or height that is not above 0.
Mesh make_grid(const GridSettings& settings);

}  // namespace taut::sim
