#pragma once

#include "sim/mesh/types.hpp"

namespace taut::app {

/// The corners of a triangle, in metres. One without area is the segment or the point that its corners span.
using Corners = std::array<sim::Vec3, 3>;

// Each returns a point that both triangles have, in metres and rounded, if they cross. Whether they do is
// decided exactly (orientation()); to touch is to cross.

/// For triangles that share no vertex: they cross if they have any point in common.
std::optional<sim::Vec3> crossing_place(const Corners& a, const Corners& b);

/// For triangles that share their corner 0: they cross if they have a point in common that lies elsewhere.
std::optional<sim::Vec3> crossing_place_beside_vertex(const Corners& a, const Corners& b);

/// For triangles that share their corners 0 and 1: they cross if they are folded flat onto each other, so
/// that they have a point in common that is not on that edge. The place is then the middle of the edge.
std::optional<sim::Vec3> crossing_place_beside_edge(const Corners& a, const Corners& b);

/// Returns whether all coordinates are finite and of sizes below 1e100, as all points here must be: others have no
/// rational numbers.
bool is_exactly_comparable(const sim::Vec3& point);

/// Returns the sign, -1, 0 or 1, of (a - d) . ((b - d) x (c - d)): 0 exactly if the four points are in one
/// plane. The sign is exact: a value that rounding could have turned (Shewchuk 1997, the error bounds "A") is
/// computed again with rational numbers of any length.
int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d);

/// Returns the sign, -1, 0 or 1, of (a - c) x (b - c): 0 exactly if the three points are on one line. Exact
/// as well.
int orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c);

}  // namespace taut::app
