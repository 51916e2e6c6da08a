#pragma once

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Statistics over the structural springs. Stretch is length / rest length - 1; it has no unit. All zero if
/// there are no structural springs.
struct Stretch {
  /// Largest stretch of any spring; negative if every spring is shorter than its rest length.
  double max = 0.0;
  /// 99th percentile: at most one spring in a hundred is stretched more.
  double p99 = 0.0;
  double mean = 0.0;
  /// Largest 1 - length / rest length of any spring; at least 0.
  double max_compression = 0.0;
};

/// Measures the structural springs. Here and below `positions` are in metres, one per vertex.
Stretch measure_stretch(const Springs& springs, std::span<const Vec3> positions);

/// Returns, per vertex, the largest stretch of the structural springs that end there; 0 without any.
std::vector<double> vertex_stretch(const Springs& springs, std::span<const Vec3> positions);

/// Statistics over the triangles that have a surface. The surface stretch of a triangle is the largest singular value
/// of its deformation gradient F, minus 1; it has no unit. It bounds the stretch in every direction within the
/// triangle, as in strain limiting (Wang, O'Brien and Ramamoorthi 2010; Li, Kaufman and Jiang 2021). Edges can stretch
/// less: a triangle whose edges shorten can grow across them. A grid cell counts as two triangles. All diagonals run
/// the same way, so symmetric cloth can measure more on one side. All zero if no triangle has a surface.
struct SurfaceStretch {
  double max = 0.0;  ///< largest surface stretch; negative if all triangles are smaller than at rest
  /// 99th percentile: at most one triangle in a hundred is stretched more.
  double p99 = 0.0;
};

SurfaceStretch measure_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Returns the surface stretch per triangle, or 0 for triangles without a surface.
std::vector<double> triangle_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Returns, per vertex, the largest surface stretch of its triangles; 0 if none has a surface.
std::vector<double> vertex_surface_stretch(const Garment& garment, std::span<const Vec3> positions);

/// Two shapes, one frame apart. Positions are in metres, one per vertex, in both spans. Speeds are measured
/// over a whole frame because a solver may move resting cloth back and forth within a frame.
struct ShapeChange {
  std::span<const Vec3> before;
  std::span<const Vec3> now;
  double time_s = 0.0;  ///< time from `before` to `now`; above 0
};

/// The paper's convergence: the length of p(t) - p(t - dt), in metres. Here dt is one frame.
struct Convergence {
  double max_m = 0.0;  ///< maximum over all vertices
  /// Root mean square over all vertices.
  double rms_m = 0.0;
};

/// Returns the convergence of one vertex, in metres.
double vertex_convergence_m(const ShapeChange& change, Index vertex);
Convergence measure_convergence(const ShapeChange& change);

/// Returns the root mean square of the speeds of all vertices, in m/s.
double rms_speed(const ShapeChange& change);

/// Sums over all vertices, in joules.
struct Energy {
  double kinetic_j = 0.0;
  /// Energy in the field of gravity, zero at the origin.
  double potential_j = 0.0;
};

/// Requires a shape change of this garment.
Energy measure_energy(const Garment& garment, const ShapeChange& change, const Vec3& gravity_m_per_s2);

/// Largest coordinate in metres; beyond it the simulation has diverged. Its square still fits into the renderer's
/// single precision.
inline constexpr double max_coordinate_m = 1e9;

/// Returns the first vertex with a coordinate that is beyond `max_coordinate_m` or not a number. Returns the number
/// of positions if there is no such vertex.
std::size_t first_lost(std::span<const Vec3> positions);

}  // namespace taut::sim
