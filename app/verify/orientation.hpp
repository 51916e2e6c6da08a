#pragma once

#include "sim/mesh/types.hpp"

namespace taut::app {

// Coordinates must be finite and of sizes below 1e100.

/// Returns the sign, -1, 0 or 1, of (a - d) . ((b - d) x (c - d)): 0 exactly if the four points are in one
/// plane. The sign is exact: a value that rounding could have turned (Shewchuk 1997, the error bounds "A") is
/// computed again with whole numbers of any length.
int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d);

/// Returns the sign, -1, 0 or 1, of (a - c) x (b - c): 0 exactly if the three points are on one line. Exact
/// as well.
int orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c);

}  // namespace taut::app
