#pragma once

#include <vector>

#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Places the vertices of `shirt` on the surface of `surface`, another mesh of the same pattern. Each vertex
/// keeps its place on its flat piece; a vertex of a seam keeps its place along the seam. Returns positions in
/// metres, per vertex of `shirt`. `surface_positions` has one position per vertex of `surface`.
std::vector<Vec3> lift_onto(const Shirt& shirt, const Shirt& surface,
                            const std::vector<Vec3>& surface_positions);

}  // namespace taut::tailor
