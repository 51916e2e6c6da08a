#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/solvers/bounded/kernels/contact_kernels.hpp"
#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/kernels/sliced_matrix.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::sim::bounded {

/// Input of the wind kernel besides the cloth, in single precision.
struct AirFlow {
  std::array<float, 3> velocity_m_per_s = {0.0F, 0.0F, 0.0F};
  const float* fractions = nullptr;    ///< fraction of the velocity that each triangle meets, one per lane
  float half_density_pressure = 0.0F;  ///< 1/2 rho C_n, in kg/m^3
  float half_density_friction = 0.0F;  ///< 1/2 rho C_t, in kg/m^3
  /// Duration of the force divided by the areal density of the cloth, in s m^2/kg.
  float time_per_density = 0.0F;
  float per_time_step = 0.0F;  ///< 1 / dt, in 1/s
};

/// Input of a prediction besides the cloth.
struct Prediction {
  float decay = 1.0F;       ///< factor on all velocities per time step
  float dt_squared = 0.0F;  ///< squared time step, in s^2
  /// Displacement of the pins from the start of the frame to the end of this step, in m.
  Float4 pins_moved;
};

/// Loops in which the solver spends its time. Each does the same operations on every element in the same order for any
/// width of vectors, so all vector units give the same bits. There is no fused multiply-add, no approximate reciprocal
/// and no approximate square root. Arrays of Float4 have one entry per solver index unless said otherwise.
struct Kernels {
  /// Eq. (1) in displacements d since the start of the frame, in m, for solver indices [begin, end), which are
  /// multiples of the block size:
  ///   previous <- d + (d - previous) decay + a dt^2
  /// where `current` holds d. The caller then swaps the two arrays. A vertex predicted beyond the length of its tether
  /// is moved back to that length, with the relative error of `sweep`. `tethers` has one entry per solver index, or is
  /// null.
  void (*predict)(std::size_t begin, std::size_t end, const Prediction& prediction, const Tether* tethers,
                  const Float4* accelerations, const Float4* current, Float4* previous);

  /// Sets the vectors L'_start (start_x, start_y, start_z) of the springs in blocks [begin, end).
  void (*start_springs)(const StartRows& start, std::size_t begin, std::size_t end, SpringLanes& springs);

  /// Eqs. (2) and (3) for blocks [begin, end), which must be of one colour. Springs that are too long are
  /// shortened to their rest length. Springs that are too short correct a fraction of their error. With L' =
  /// L'_start + d_i - d_j the relative error is computed without a square root as
  ///   (|L'|^2 - |L|^2) / (|L'|^2 + |L|^2).
  /// It equals (|L'| - |L|) / |L'| up to the second order in the error and never exceeds 1 (Jakobsen 2001).
  void (*sweep)(const SpringLanes& springs, std::size_t begin, std::size_t end, Float4* rows);

  /// Shortens the springs that exceed the bound, in the listed blocks, which must be of one colour. A spring
  /// with |L'|^2 above `squared_bound` |L|^2 gets `relaxation` times the correction it needs.
  void (*shorten)(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
                  float relaxation, Float4* rows);

  /// Writes the largest |L'|^2 / |L|^2 of the springs of each block in [begin, end) to `squared_ratios`,
  /// which has one entry per block.
  void (*find_max_ratios)(const SpringLanes& springs, std::size_t begin, std::size_t end, const Float4* rows,
                          float* squared_ratios);

  /// Sets the deformation gradients at the start of the frame of the triangles in blocks [begin, end).
  void (*start_surface)(const StartRows& start, std::size_t begin, std::size_t end, SurfaceLanes& triangles);

  /// The strong constraint of a triangle, for the blocks of `range`. If a singular value s of the deformation gradient
  /// F exceeds 1 along the direction v, the corners move along F v until it is 1; if it is below 1, they correct a
  /// fraction of the error. The error is (s^2 - 1) / (s^2 + 1), as for springs. Both singular values are corrected at
  /// once; to first order they do not disturb each other. Corner k moves by
  ///   -error w_k (g_k v) / (sum of w (g v)^2) F v,
  /// the projection onto the half-space that touches s <= 1 there (Polyak 1969). See SurfaceMobility. Adds the
  /// corrections to `sums`, by block of the lanes, unless it is null.
  void (*sweep_surface)(const SurfaceLanes& triangles, const BlockRange& range, SurfaceSums* sums, Float4* rows);

  /// Shortens the triangles that exceed the bound in either direction, in the listed blocks, which must be of
  /// one colour, with `relaxation` times the correction they need.
  void (*shorten_surface)(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks, float squared_bound,
                          float relaxation, Float4* rows);

  /// Writes the largest s^2 of the triangles of each block in [begin, end) to `squared_ratios`, which has one
  /// entry per block.
  void (*find_max_surface_ratios)(const SurfaceLanes& triangles, std::size_t begin, std::size_t end, const Float4* rows,
                                  float* squared_ratios);

  /// Writes the force of the air on each corner of triangles [begin, end), multiples of the block size, in N.
  /// `corner_forces` has one entry per triangle. Positions are `start` + `current`, in m; `previous` is one time step
  /// earlier. `opposed` is the velocity change in m/s expected from all other forces in the time; its fourth number is
  /// 1 for movable vertices. The law equals sim/forces.hpp, which ignores other forces.
  void (*wind)(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
               const Float4* start, const Float4* current, const Float4* previous, const Float4* opposed,
               Float4* corner_forces);

  /// Adds the matrix rows of slices [begin, end): result += sum over the columns of value (x_column - x_row).
  void (*add_product)(const SlicedMatrix& matrix, std::size_t begin, std::size_t end, const Float4* positions,
                      Float4* result);

  /// Kernels of the search for near pairs.
  ContactKernels contact;
};

/// Addition to the divisor of SurfaceMobility, which is 1/2 on average. Without it a triangle with two corners pinned
/// too far apart would throw its third corner any distance. Higher values correct less at once.
inline constexpr float min_mobility = 1.0F / 256.0F;

/// Smallest half difference of squared singular values; below the resolution of single precision.
inline constexpr float min_radius = 1e-12F;

/// Returns the kernels for a unit. Throws std::invalid_argument if this processor does not have it.
const Kernels& kernels_for(VectorUnit unit);

}  // namespace taut::sim::bounded
