#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"
#include "tailor/flat/planar.hpp"

namespace taut::tailor {

/// The Delaunay triangles inside a counter-clockwise outline, which is the first `outline_count` points, in
/// order; the rest are interior points. Counter-clockwise, each beginning with its smallest index, sorted:
/// the result does not depend on the order in which the library finds them.
/// Throws std::runtime_error where the triangulation is not exactly the outline's inside, that is, where an
/// outline edge is no Delaunay edge because a point lies too close to it.
std::vector<sim::Triangle> triangulate(std::span<const Vec2> points, std::size_t outline_count);

}  // namespace taut::tailor
