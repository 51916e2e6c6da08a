#pragma once

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// One triangle at rest, laid flat: corner 0 at the origin, corner 1 on the first axis. With the current edges e1 and
/// e2 from corner 0 to the others, the columns of the deformation gradient F (3 x 2) are
///   f1 = along e1,   f2 = across e2 - skew e1   (all per metre).
/// A length along the direction (cos a, sin a) at rest is multiplied by |f1 cos a + f2 sin a|.
struct TriangleAtRest {
  double along_per_m = 0.0;   ///< 1 / |e1|
  double across_per_m = 0.0;  ///< 1 / height of corner 2 above e1; 0 without a surface
  double skew_per_m = 0.0;

  /// Returns false if the smallest height is below a thousandth of the longest edge. Rounding decides the normal of
  /// such a needle, so only its edges are bounded and measured.
  bool has_surface() const { return across_per_m > 0.0; }
};

/// Returns the height above the longest edge, in m. Requires a surface.
double min_height_m(const TriangleAtRest& rest);

/// Returns, per corner, the derivatives of the two columns of F by the corner's position. The derivative of F v is
/// their product with v.
std::array<Vec2, 3> gradients_by_corners(const TriangleAtRest& rest);

/// Returns one entry per triangle.
std::vector<TriangleAtRest> triangles_at_rest(const Mesh& mesh);

/// Columns of a triangle's deformation gradient. Both are 0 if the triangle has no surface.
struct DeformationGradient {
  Vec3 along = Vec3(0.0);
  Vec3 across = Vec3(0.0);
};

/// `corners` are the current positions, in metres.
DeformationGradient deformation_gradient(const TriangleAtRest& rest, const std::array<Vec3, 3>& corners);

/// Singular values of F: the ratios of current to rest length along the direction of largest stretch, and at right
/// angles to it.
struct PrincipalStretches {
  double max_ratio = 0.0;
  double min_ratio = 0.0;
};

PrincipalStretches principal_stretches(const DeformationGradient& gradient);

/// Returns the unit direction v at rest for which |F v| is the largest singular value; any direction if all are equal.
Vec2 principal_direction(const DeformationGradient& gradient);

/// Returns the unit direction in a triangle at rest that is nearest to upright; nearest to z if the triangle lies flat.
Vec2 upright_direction(const std::array<Vec3, 3>& corners);

/// Returns the warp per triangle: the unit direction at rest along which only the second texture coordinate changes, if
/// the coordinates lay out panels as cut. Returns the upright direction if they do not vary.
std::vector<Vec2> warps_from_coordinates(const Mesh& mesh, std::span<const glm::vec2> corner_coordinates);

}  // namespace taut::sim
