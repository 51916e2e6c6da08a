#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The corners of a triangle, in m.
using Corners = std::array<Vec3, 3>;

/// How near two triangles are.
struct TrianglePairMeasure {
  /// The distance of the corners and edges of the one from the corners, edges and face of the other, in m, where edges
  /// are not looked at beside faces: of triangles that cross it may be above 0.
  double parts_m;
  bool is_pierced;  ///< an edge of the one goes through the other for certain

  bool is_crossing() const;
  double distance_m() const { return is_crossing() ? 0.0 : parts_m; }
};

/// Nearer than this, in m, things touch, and what touches crosses: far more than rounding moves a nearest point, so
/// that no crossing is missed for it.
inline constexpr double touching_m = 1e-12;

inline bool TrianglePairMeasure::is_crossing() const { return is_pierced || parts_m <= touching_m; }

/// Returns the distance of a point from a triangle, in m.
double point_triangle_distance_m(const Vec3& point_m, const Corners& triangle);

/// Measures two triangles that share no vertex. Beyond the reach the answer may be infinite.
TrianglePairMeasure measure_pair(const Triangle& s, const Triangle& t, std::span<const Vec3> s_positions_m,
                                 std::span<const Vec3> t_positions_m,
                                 double reach_m = std::numeric_limits<double>::infinity());

/// Measures two triangles that share a vertex or an edge: of these only what does not belong to both counts. Two that
/// share an edge cross if they are folded flat onto each other.
TrianglePairMeasure measure_neighbours(Triangle s, Triangle t, std::span<const Vec3> positions_m);

/// Returns whether such triangles cross.
bool neighbours_cross(Triangle s, Triangle t, std::span<const Vec3> positions_m);

}  // namespace taut::sim
