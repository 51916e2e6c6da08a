#pragma once

#include "tests/reference/cases.hpp"

namespace reference {

/// How far two shapes of the same cloth are from each other.
struct Difference {
  double hausdorff_m = 0.0;  ///< from the vertices of either to the surface of the other, the largest
  double mean_m = 0.0;       ///< root mean square of the same
  double vertices_m = 0.0;   ///< root mean square of the ways from each vertex to itself
};
Difference difference(const Surface& one, const Surface& other);

/// How cloth hangs.
struct Drape {
  double lowest_m = 0.0;
  double mean_m = 0.0;     ///< height, over the area at rest
  double shadow_m2 = 0.0;  ///< seen along y
};
Drape drape_of(const Surface& surface, const std::vector<double>& masses_kg);

/// The vertices of triangles alone, without the ball's.
Surface surface_of(const Cloth& cloth, const Vector& x);

}  // namespace reference
