#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The corners of a triangle, in m.
using Corners = std::array<Vec3, 3>;

/// How near two triangles are.
struct TrianglePairMeasure {
  double distance_m;  ///< 0 where they cross
  bool is_crossing;
};

/// Nearer than this, in m, things touch, and what touches crosses: far more than rounding moves a nearest point, so that
/// no crossing is missed for it.
inline constexpr double touching_m = 1e-12;

/// Returns the distance of a point from a triangle, in m.
double point_triangle_distance_m(const Vec3& point_m, const Corners& triangle);

/// Measures two triangles of a mesh. Of two that share a vertex only what does not share it counts: `distance_m` is that
/// of edges and vertices of the one from those of the other, and an edge crosses a triangle that it has no vertex in
/// common with. Two that share an edge cross if they are folded flat onto each other.
TrianglePairMeasure measure_pair(Triangle s, Triangle t, std::span<const Vec3> s_positions_m,
                                 std::span<const Vec3> t_positions_m, bool are_of_one_mesh);

}  // namespace taut::sim
