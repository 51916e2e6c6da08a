#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/solvers/bounded/kernels/lanes.hpp"
#include "sim/solvers/bounded/kernels/sliced_matrix.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::sim::bounded {

/// What the wind kernel needs besides the cloth; in single precision, as the kernel computes.
struct AirFlow {
  std::array<float, 3> velocity_m_per_s = {0.0F, 0.0F, 0.0F};
  float half_density_pressure = 0.0F;  ///< 1/2 rho C_n, in kg/m^3
  float half_density_friction = 0.0F;  ///< 1/2 rho C_t
  float time_per_density = 0.0F;       ///< the time the force acts over the cloth's density, in s m^2/kg
  float per_time_step = 0.0F;          ///< 1 / dt, in 1/s
};

/// What a prediction needs besides the cloth.
struct Prediction {
  float decay = 1.0F;       ///< of velocities in one time step
  float dt_squared = 0.0F;  ///< in s^2
  Float4 pins_moved;        ///< since the frame began, at the end of the time step
};

/// The loops in which the time goes. Each does the same operations on every element in the same order,
/// whatever the width of the processor's vectors, so that all of them give the same bits; no fused
/// multiply-add, no approximate reciprocal, no approximate square root.
struct Kernels {
  /// Eq. (1) in displacements d since the frame's start, for rows [begin, end), multiples of the block size:
  ///   previous <- d + (d - previous) decay + a dt^2
  /// where `current` holds d. The caller then lets the two change places. Vertices predicted further away
  /// than their tethers reach are brought back to where these end, by the same error as in `sweep`; `tethers`
  /// is null where there are none.
  void (*predict)(std::size_t begin, std::size_t end, const Prediction& prediction, const Tether* tethers,
                  const Float4* accelerations, const Float4* current, Float4* previous);

  /// Sets L'_start of the springs in blocks [begin, end).
  void (*start_springs)(const StartRows& start, std::size_t begin, std::size_t end, SpringLanes& springs);

  /// Eqs. (2)-(3) for blocks [begin, end) of one colour: springs that are too long are shortened to rest,
  /// those too short give back a part. With L' = L'_start + d_i - d_j the relative error is taken as
  /// (|L'|^2 - |L|^2) / (|L'|^2 + |L|^2), which is (|L'| - |L|) / |L'| to the second order in the error and
  /// never above 1, without a square root (Jakobsen 2001).
  void (*sweep)(const SpringLanes& springs, std::size_t begin, std::size_t end, Float4* rows);

  /// For springs longer than the bound alone, in the blocks named, all of one colour: where |L'|^2 is above
  /// `squared_bound` |L|^2, `relaxation` times what is needed.
  void (*shorten)(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
                  float relaxation, Float4* rows);

  /// For each block [begin, end) the largest |L'|^2 / |L|^2 of its springs, into `squared_ratios` by block.
  void (*largest_ratios)(const SpringLanes& springs, std::size_t begin, std::size_t end, const Float4* rows,
                         float* squared_ratios);

  /// A sixth of the doubled force of the air on each triangle of lanes [begin, end), a multiple of the block
  /// size: what each corner gets, in N. Positions are `start` + `current`; `previous` is one dt before.
  void (*wind)(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
               const Float4* start, const Float4* current, const Float4* previous, Float4* corner_forces);

  /// For the rows of slices [begin, end): result += sum over columns of value (x_column - x_row).
  void (*add_product)(const SlicedMatrix& matrix, std::size_t begin, std::size_t end, const Float4* positions,
                      Float4* result);
};

/// Throws std::invalid_argument on a unit this processor lacks.
const Kernels& kernels_for(VectorUnit unit);

}  // namespace taut::sim::bounded
