#pragma once

#include "app/verify/triangle_crossing.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Returns all pairs of triangles of the cloth that cross each other (triangle_crossing.hpp), ordered by their indices.
/// Vertices with equal indices are shared, wherever they are. Throws std::invalid_argument if a triangle has a corner
/// that is not finite, and Interrupted.
std::vector<sim::CrossingPair> crossing_pairs(const sim::Surface& cloth);

/// Returns all pairs of a triangle of the cloth and one of the body that have a point in common, in the same order.
std::vector<sim::CrossingPair> crossing_pairs(const sim::Surface& cloth, const sim::Surface& body);

/// Depth in a body without a mesh up to which a point counts as outside, in metres. It ends the search for the deepest
/// point of a triangle, which halves the triangle.
inline constexpr double max_depth_m = 5e-10;

/// Returns whether a point of the triangle is below the plane. The normal must have length 1.
bool enters_half_space(const Corners& triangle, const sim::Vec3& point_m, const sim::Vec3& normal);

/// A limb: all points nearer to a segment than a radius, which changes linearly along it and is measured at right
/// angles to the segment. If both ends are equal, it is a ball of the start's radius.
struct LimbShape {
  sim::Vec3 start_m = sim::Vec3(0.0);
  sim::Vec3 end_m = sim::Vec3(0.0);
  double start_radius_m = 0.0;
  double end_radius_m = 0.0;
};

/// Returns whether a point of the triangle is in the limb.
bool enters_limb(const Corners& triangle, const LimbShape& limb);

}  // namespace taut::app
