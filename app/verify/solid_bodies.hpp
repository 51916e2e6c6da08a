#pragma once

#include "app/verify/crossing_pairs.hpp"
#include "app/verify/triangle_crossing.hpp"

namespace taut::app {

/// How deep a point may be in a body that is no mesh and still count as outside, in metres. It ends the
/// search for the deepest point of a triangle, which halves the triangle.
inline constexpr double most_depth_m = 5e-10;

/// Returns whether a point of the triangle is below the plane. The normal must have length 1.
bool enters_half_space(const Corners& triangle, const sim::Vec3& point_m, const sim::Vec3& normal);

/// A limb: all points that are nearer to a segment than a radius, which changes linearly along it, found at
/// right angles to the segment. Where both ends are alike it is a ball of the start's radius.
struct Limb {
  sim::Vec3 start_m = sim::Vec3(0.0);
  sim::Vec3 end_m = sim::Vec3(0.0);
  double start_radius_m = 0.0;
  double end_radius_m = 0.0;
};

/// Returns whether a point of the triangle is in the limb.
bool enters_limb(const Corners& triangle, const Limb& limb);

/// Returns how often a closed surface that faces outwards goes around the point: 1 within it, 0 outside, to
/// rounding. It adds up the solid angles of its triangles (Van Oosterom and Strackee 1983), and so takes time
/// in proportion to these. Requires a point that is not on the surface.
double winding_number(const sim::Vec3& point_m, const Surface& surface);

}  // namespace taut::app
