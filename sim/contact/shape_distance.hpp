#pragma once

#include "sim/contact/bodies.hpp"
#include "sim/contact/triangle_pair.hpp"

namespace taut::sim {

/// Returns the distance of a triangle from a plane, sphere or capsule, in m, below 0 where it enters; infinite for a
/// mesh and beyond the reach.
double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m);

}  // namespace taut::sim
