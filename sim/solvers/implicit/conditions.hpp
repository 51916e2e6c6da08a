#pragma once

#include "sim/garment.hpp"

namespace taut::sim::implicit {

using Mat3 = glm::dmat3;

/// A condition that cloth opposes: a number C that is 0 at rest, by the positions x_i of up to four vertices (Baraff and
/// Witkin 1998, section 4.1). Its energy is 1/2 k C^2.
struct Condition {
  double value = 0.0;
  int count = 0;                    ///< of the vertices
  std::array<Index, 4> vertices{};  ///< each once
  std::array<Vec3, 4> gradients{};  ///< dC / dx_i
  /// d2C / dx_i dx_j = weights[i] weights[j] curvature, as far as it is used; never negative definite.
  std::array<double, 4> weights{};
  Mat3 curvature = Mat3(0.0);
};

/// A triangle with its warp and weft at rest. w_u and w_v, the derivatives of positions by lengths at rest
/// along warp and weft (eq. 9), are sums of the corners times weights.
struct WovenTriangle {
  Triangle corners{};
  std::array<double, 3> along_warp{}, along_weft{};  ///< weights of the corners, per m
  double root_area_m = 0.0;                          ///< of the area at rest
};

/// Two triangles at an edge.
struct Hinge {
  std::array<Index, 4> vertices{};  ///< the edge's ends, the third corner of one triangle and of the other
  double rest_angle_rad = 0.0;
  /// Times the bending rigidity: the stiffness, |edge|^2 / (sum of both areas). Gives a sheet that is bent
  /// to a cylinder the energy of a plate, on grids and on equilateral triangles.
  double shape = 0.0;
};

/// Returns the triangles that have a surface. The warp of a grid runs down its columns; that of any other
/// triangle along its first side, as models bring none.
std::vector<WovenTriangle> woven_triangles(const Garment& garment);
/// Returns the edges at which two triangles with a surface meet.
std::vector<Hinge> hinges(const Garment& garment);

/// Returns w_u or w_v, by the weights for it.
Vec3 derivative(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                std::span<const Vec3> positions_m);

/// A spring: C = its length minus that at rest, in m, so that 1/2 k C^2 is Hooke's law.
Condition spring_condition(const Edge& ends, double rest_length_m, std::span<const Vec3> positions_m);
/// Stretch, eq. (10), along the direction of the weights: C = sqrt(a) (|w| - 1) for the area a. The paper
/// multiplies by a. With its root the stiffness is in N/m and does not depend on the mesh.
Condition stretch_condition(const WovenTriangle& triangle, const std::array<double, 3>& weights,
                            std::span<const Vec3> positions_m);
/// Shear, section 4.3: C = sqrt(a) w_u . w_v. Its second derivative is not definite and left out.
Condition shear_condition(const WovenTriangle& triangle, std::span<const Vec3> positions_m);
/// Bend, section 4.3: C = angle between the triangles minus that at rest, in radians, towards -pi to pi. Its
/// second derivative is left out. 0 where a triangle has collapsed.
Condition bend_condition(const Hinge& hinge, std::span<const Vec3> positions_m);

}  // namespace taut::sim::implicit
