#pragma once

#include <vector>

#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Where the vertices of one meshing of the pattern lie on the surface of another one of the same pattern:
/// every vertex keeps its place on the flat piece, every seam vertex its place along the seam. This carries a
/// fit from a coarse shirt to a finer one, and reduces a fine shirt to fewer triangles.
std::vector<Vec3> lift_onto(const Shirt& shirt, const Shirt& surface,
                            const std::vector<Vec3>& surface_positions);

}  // namespace taut::tailor
