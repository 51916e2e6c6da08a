#pragma once

#include "sim/mesh/types.hpp"

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

/// Returns whether all coordinates are finite and below 1e100 in size, as all functions here require. Other values have
/// no rational numbers.
bool is_exactly_comparable(const sim::Vec3& point);

/// Returns the sign, -1, 0 or 1, of (a - d) . ((b - d) x (c - d)). It is 0 exactly if the four points are in one plane.
/// The sign is exact: a value that rounding could have turned (Shewchuk 1997, the error bounds "A") is computed again
/// with rational numbers of any length.
int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d);

/// Returns the sign, -1, 0 or 1, of (a - c) x (b - c), exactly likewise. It is 0 exactly if the three points are on one
/// line.
int orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c);

}  // namespace taut::app
