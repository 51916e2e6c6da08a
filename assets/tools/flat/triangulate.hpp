#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"
#include "tailor/flat/planar.hpp"

namespace taut::tailor {

/// Delaunay triangulation of the inside of an outline. The first `outline_count` points are the outline, in
/// counter-clockwise order; the others are inside. Triangles are counter-clockwise and begin with their
/// smallest index. They are sorted, so the result does not depend on the library's order. Throws
/// std::runtime_error if an edge of the outline is not a Delaunay edge, because a point is too close to it.
std::vector<sim::Triangle> triangulate(std::span<const Vec2> points, std::size_t outline_count);

}  // namespace taut::tailor
