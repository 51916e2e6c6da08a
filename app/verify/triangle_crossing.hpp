#pragma once

#include "app/verify/orientation.hpp"

namespace taut::app {

/// Corners of a triangle, in metres. A triangle without area is the segment or the point that its corners span.
using Corners = std::array<sim::Vec3, 3>;

// Functions that return a common point of two triangles, in metres and rounded, if they cross. The decision is exact
// (orientation()). Triangles that touch cross.

/// Requires triangles that share no vertex. They cross if they have any common point.
std::optional<sim::Vec3> crossing_place(const Corners& a, const Corners& b);

/// Requires triangles that share their corner 0. They cross if they have another common point.
std::optional<sim::Vec3> crossing_place_beside_vertex(const Corners& a, const Corners& b);

/// Requires triangles that share their corners 0 and 1. They cross if they are folded flat onto each other, so that
/// they have a common point that is not on that edge. The returned point is the middle of the edge.
std::optional<sim::Vec3> crossing_place_beside_edge(const Corners& a, const Corners& b);

}  // namespace taut::app
