#pragma once

#include "sim/mesh/types.hpp"

namespace taut::app {

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
