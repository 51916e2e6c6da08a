#pragma once

#include "app/verify/crossing_pairs.hpp"

namespace taut::app {

/// Where a surface is cut.
struct CuttingPlane {
  sim::Vec3 point_m = {0.0, 0.0, 0.0};
  sim::Vec3 normal = {0.0, 1.0, 0.0};  ///< of length 1
};

/// A curve that a plane cuts out of a surface.
struct SectionCurve {
  /// Along the curve, in the plane, in m from its point. Of a level plane: x, and z backwards.
  std::vector<sim::Vec2> points_m;
  bool is_closed = false;
};

/// Returns the curves that the plane cuts out of the surface. Where more than two triangles meet at an edge
/// that is cut, curves end.
std::vector<SectionCurve> section_of(const Surface& surface, const CuttingPlane& plane);

/// Returns where a point of a curve in the plane is.
sim::Vec3 place_in(const CuttingPlane& plane, const sim::Vec2& point);

/// Returns the length along the curve, in m; of a closed one all around.
double length_m(const SectionCurve& curve);

/// Returns the corners of the points' convex hull, anticlockwise. Requires a point.
std::vector<sim::Vec2> convex_hull(std::vector<sim::Vec2> points_m);

/// Returns whether the point is within the hull, or on it.
bool is_in_hull(const std::vector<sim::Vec2>& hull, const sim::Vec2& point);

/// Returns the length of a tight tape around the points, in m: of their convex hull.
double tight_tape_m(std::vector<sim::Vec2> points_m);

/// Returns whether the closed curve goes around the plane's point.
bool is_around_point(const SectionCurve& curve);

}  // namespace taut::app
