#pragma once

#include "app/verify/triangle_crossing.hpp"

namespace taut::app {

/// A surface at one moment: positions per vertex, in metres, and triangles.
struct Surface {
  std::span<const sim::Vec3> positions_m;
  std::span<const sim::Triangle> triangles;
};

/// Two triangles that cross.
struct CrossingPair {
  sim::Index first = 0;                ///< index of a triangle of the cloth
  sim::Index second = 0;               ///< index of a triangle of the cloth above `first`, or of the body
  sim::Vec3 place_m = sim::Vec3(0.0);  ///< a common point of both, rounded
};

/// Callback that a search calls again and again; it may throw to end the search.
using Poll = std::function<void()>;

/// Returns all pairs of triangles of the cloth that cross each other (triangle_crossing.hpp), ordered by their indices.
/// Vertices with equal indices are shared, wherever they are. Throws std::invalid_argument if a triangle has a corner
/// that is not finite.
std::vector<CrossingPair> crossing_pairs(const Surface& cloth, const Poll& poll = {});

/// Returns all pairs of a triangle of the cloth and one of the body that have a point in common, in the same order.
std::vector<CrossingPair> crossing_pairs(const Surface& cloth, const Surface& body, const Poll& poll = {});

/// Returns "triangle 7 (vertices 1, 2, 3)".
std::string describe_triangle(const Surface& surface, sim::Index triangle);

/// Returns "2 pairs of triangles cross, the first: triangle 7 (vertices 1, 2, 3) and triangle 9 (vertices 4,
/// 5, 6) at [0.10000, 0.20000, 0.30000] m". The pairs must be of the cloth itself, at least one.
std::string describe(const Surface& cloth, std::span<const CrossingPair> pairs);

/// Returns "[0.10000, 0.20000, 0.30000] m".
std::string describe_place(const sim::Vec3& place_m);

/// Returns "[0.1, 0.2, 0.3]", to six digits, for places in the unit of a file.
std::string describe_point(const sim::Vec3& point);

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

/// Returns the number of times that a closed surface facing outwards winds around the point: 1 inside, 0 outside, up to
/// rounding. The solid angles of its triangles are added up (Van Oosterom and Strackee 1983), in time proportional to
/// their number. Requires a point that is not on the surface.
double winding_number(const sim::Vec3& point_m, const Surface& surface);

}  // namespace taut::app
