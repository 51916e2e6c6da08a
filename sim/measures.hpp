#pragma once

#include <span>

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Of the structural springs; stretch is length / rest length - 1.
struct Stretch {
  double max = 0.0;  ///< of the longest; negative where every spring is shorter than at rest
  double p99 = 0.0;  ///< the 99th percentile: no more than one spring in a hundred exceeds it
  double mean = 0.0;
  double max_compression = 0.0;  ///< 1 - length / rest length of the shortest, at least 0
};

Stretch measure_stretch(const Springs& springs, std::span<const Vec3> positions);

/// For each vertex the largest stretch of the structural springs that end there.
std::vector<double> vertex_stretch(const Springs& springs, std::span<const Vec3> positions);

/// A shape and the one a frame before it; positions in metres, by vertex. Speeds are taken between the shapes
/// of two frames: between two time steps of one frame a solver may move cloth to and fro that rests.
struct ShapeChange {
  std::span<const Vec3> before;
  std::span<const Vec3> now;
  double time_s = 0.0;  ///< between the two
};

/// The length of p(t) - p(t - dt), which the paper calls the convergence, with a frame for dt; in metres.
struct Convergence {
  double max_m = 0.0;
  double rms_m = 0.0;
};

double convergence_of(const ShapeChange& change, Index vertex);
Convergence measure_convergence(const ShapeChange& change);

/// Root mean square over the vertices, in m/s.
double rms_speed(const ShapeChange& change);

/// In joules; the potential energy is gravity's, zero at the origin.
struct Energy {
  double kinetic_j = 0.0;
  double potential_j = 0.0;
};

Energy measure_energy(const Garment& garment, const ShapeChange& change, const Vec3& gravity_m_per_s2);

/// No garment goes so far; single precision, in which it is drawn, still has its square.
inline constexpr double lost_at_m = 1e9;

/// The first vertex with a coordinate beyond `lost_at_m` or not a number, or the number of positions where
/// there is none.
std::size_t first_lost(std::span<const Vec3> positions);

}  // namespace taut::sim
