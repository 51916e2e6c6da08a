#pragma once

#include "tests/study/reference/cases.hpp"

namespace reference {

/// Difference of two shapes of the same cloth.
struct Difference {
  double hausdorff_m = 0.0;  ///< largest distance from a vertex of either to the surface of the other
  double mean_m = 0.0;       ///< root mean square of these distances
  double vertices_m = 0.0;   ///< root mean square of the distances of each vertex between the two shapes
};
Difference difference(const Surface& one, const Surface& other);

/// Measures of hanging cloth.
struct Drape {
  double min_height_m = 0.0;
  double mean_m = 0.0;     ///< mean height, weighted by area at rest
  double shadow_m2 = 0.0;  ///< area in the view along y
};
Drape measure_drape(const Surface& surface, const std::vector<double>& masses_kg);

/// Returns the vertices of triangles, without the ball's.
Surface make_surface(const Cloth& cloth, const Vector& x);

}  // namespace reference
