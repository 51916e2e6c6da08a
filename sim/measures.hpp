#pragma once

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Statistics over the structural springs. Stretch is length / rest length - 1; it has no unit. All zero if
/// there are no structural springs.
struct Stretch {
  /// The stretch of the most stretched spring; negative if every spring is shorter than its rest length.
  double max = 0.0;
  /// The 99th percentile: at most one spring in a hundred is stretched more than this.
  double p99 = 0.0;
  double mean = 0.0;
  /// 1 - length / rest length of the most compressed spring; at least 0.
  double max_compression = 0.0;
};

/// Here and below `positions` are in metres, one per vertex.
Stretch measure_stretch(const Springs& springs, std::span<const Vec3> positions);

/// Returns, per vertex, the largest stretch of the structural springs that end there, or 0 where none ends.
std::vector<double> vertex_stretch(const Springs& springs, std::span<const Vec3> positions);

/// Statistics over the triangles that have a surface: the largest singular value of the deformation gradient
/// F, minus 1, which has no unit; what strain limiting bounds (Wang, O'Brien and Ramamoorthi 2010; Li,
/// Kaufman and Jiang 2021). No direction within a triangle is stretched by more. Springs are edges and can be
/// stretched by less: a triangle whose edges shorten can grow across them. A cell of a grid is measured as
/// the two triangles it is made of: cloth that hangs symmetrically can be measured to stretch more on one
/// side, as all its diagonals run the same way. All zero if no triangle has a surface.
struct SurfaceStretch {
  double max = 0.0;  ///< of the most stretched triangle; negative if all are smaller than at rest
  /// The 99th percentile: at most one triangle in a hundred is stretched more than this.
  double p99 = 0.0;
};

SurfaceStretch measure_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Returns, per triangle, its surface stretch, or 0 where it has no surface.
std::vector<double> triangle_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Returns, per vertex, the largest surface stretch of the triangles there, or 0 where none has a surface.
std::vector<double> vertex_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Two shapes, one frame apart. Positions are in metres, one per vertex, in both spans. Speeds are measured
/// over a whole frame because a solver may move resting cloth back and forth within a frame.
struct ShapeChange {
  std::span<const Vec3> before;
  std::span<const Vec3> now;
  double time_s = 0.0;  ///< from `before` to `now`; above 0
};

/// The paper's convergence: the length of p(t) - p(t - dt), in metres. Here dt is one frame.
struct Convergence {
  double max_m = 0.0;  ///< over all vertices
  /// Root mean square over all vertices.
  double rms_m = 0.0;
};

/// The convergence of one vertex, in metres.
double convergence_of(const ShapeChange& change, Index vertex);
/// The convergence of all vertices.
Convergence measure_convergence(const ShapeChange& change);

/// Returns the root mean square of the speeds of all vertices, in m/s.
double rms_speed(const ShapeChange& change);

/// Sums over all vertices, in joules.
struct Energy {
  double kinetic_j = 0.0;
  /// Of gravity, zero at the origin.
  double potential_j = 0.0;
};

/// `change` must be one of this garment.
Energy measure_energy(const Garment& garment, const ShapeChange& change, const Vec3& gravity_m_per_s2);

/// A coordinate beyond this, in metres, means that the simulation diverged. Its square still fits into the
/// single precision of the renderer.
inline constexpr double lost_at_m = 1e9;

/// Returns the first vertex with a coordinate that is beyond `lost_at_m` or not a number. Returns the number
/// of positions if there is no such vertex.
std::size_t first_lost(std::span<const Vec3> positions);

}  // namespace taut::sim
