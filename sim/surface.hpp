#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// One triangle at rest, laid flat: corner 0 at the origin, corner 1 on the first axis. With the edges e1 and
/// e2 from corner 0 to the others as they are now, the columns of the deformation gradient F (3 x 2) are
///   f1 = along e1,   f2 = across e2 - skew e1   (all per metre).
/// Lengths along the direction (cos a, sin a) at rest are now |f1 cos a + f2 sin a| times as long.
struct TriangleAtRest {
  double along_per_m = 0.0;   ///< 1 / |e1|
  double across_per_m = 0.0;  ///< 1 / the height of corner 2 above e1; 0 in a triangle without a surface
  double skew_per_m = 0.0;

  /// False where the smallest height is below a thousandth of the longest edge. Rounding decides which way
  /// such a needle faces; it is held and measured by its edges only.
  bool has_surface() const { return across_per_m > 0.0; }
};

/// Returns the height above the longest edge, in m. Requires a surface.
double smallest_height_m(const TriangleAtRest& rest);

/// Returns, per corner, the derivatives of the two columns of F by the corner's position. The derivative of F v is the
/// product with v.
std::array<Vec2, 3> gradients_by_corners(const TriangleAtRest& rest);

/// Returns one entry per triangle.
std::vector<TriangleAtRest> triangles_at_rest(const Mesh& mesh);

/// Returns the positions of the corners.
std::array<Vec3, 3> corners_of(const Triangle& t, std::span<const Vec3> positions);

/// The deformation gradient of a triangle: its two columns. Both are 0 if the triangle has no surface.
struct DeformationGradient {
  Vec3 along = Vec3(0.0);
  Vec3 across = Vec3(0.0);
};

/// `corners` are the positions now, in metres.
DeformationGradient deformation_gradient(const TriangleAtRest& rest, const std::array<Vec3, 3>& corners);

/// The singular values of F: how many times as long lengths at rest are now, along the direction that is
/// longest and, at right angles to it, along the one that is shortest.
struct PrincipalStretches {
  double largest = 0.0;
  double smallest = 0.0;
};

PrincipalStretches principal_stretches(const DeformationGradient& gradient);

/// Returns the direction v at rest, of length 1, in which lengths are now longest: |F v| is the largest
/// singular value. Any direction if all are alike.
Vec2 principal_direction(const DeformationGradient& gradient);

/// Returns the direction in a triangle at rest that is as upright as it can be, of length 1; in one that lies
/// flat, the one along z.
Vec2 upright_in(const std::array<Vec3, 3>& corners);

/// Returns, per triangle, the direction at rest in which the second of its corners' texture coordinates alone
/// changes, of length 1: the warp, where pieces lie as they are cut. Upright where they do not say.
std::vector<Vec2> warps_of(const Mesh& mesh, std::span<const glm::vec2> corner_coordinates);

}  // namespace taut::sim
