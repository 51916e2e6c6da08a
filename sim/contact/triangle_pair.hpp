#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The corners of a triangle, in m.
using Corners = std::array<Vec3, 3>;

/// Proximity of two triangles.
struct TrianglePairMeasure {
  /// Smallest distance in m of corners to faces and of edges to edges. Edges are not compared with faces, so it may be
  /// above 0 for crossing triangles.
  double parts_m;
  bool is_pierced;  ///< an edge of one certainly pierces the other

  bool is_crossing() const;
  double distance_m() const { return is_crossing() ? 0.0 : parts_m; }
};

/// Primitives nearer than this, in m, touch and count as crossing. It far exceeds the rounding of a nearest point, so
/// that no crossing is missed.
inline constexpr double touching_m = 1e-12;

inline bool TrianglePairMeasure::is_crossing() const { return is_pierced || parts_m <= touching_m; }

double point_triangle_distance_m(const Vec3& point_m, const Corners& triangle);

/// Measures two triangles that share no vertex. The result may be infinite beyond the reach.
TrianglePairMeasure measure_pair(const Triangle& s, const Triangle& t, std::span<const Vec3> s_positions_m,
                                 std::span<const Vec3> t_positions_m,
                                 double reach_m = std::numeric_limits<double>::infinity());

/// Measures two triangles that share a vertex or an edge; shared primitives are ignored. Triangles that share an edge
/// cross if they are folded flat onto each other.
TrianglePairMeasure measure_neighbours(Triangle s, Triangle t, std::span<const Vec3> positions_m);

/// Returns whether the triangles share one vertex, and a plane through it is further than `distance_m` from the others,
/// which it separates: then they do not cross, and `parts_m` of their measure exceeds the distance.
bool corner_neighbours_lie_apart(Triangle s, Triangle t, std::span<const Vec3> positions_m, double distance_m);

/// Returns whether two triangles that share a vertex or an edge cross.
bool neighbours_cross(Triangle s, Triangle t, std::span<const Vec3> positions_m);

}  // namespace taut::sim
