#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/solvers/bounded/layout.hpp"
#include "sim/vector_unit.hpp"

namespace taut::sim::bounded {

/// What the wind kernel needs besides the cloth; in single precision, as the kernel computes.
struct AirFlow {
  std::array<float, 3> velocity_m_per_s = {0.0F, 0.0F, 0.0F};
  float half_density_pressure = 0.0F;  ///< 1/2 rho C_n, in kg/m^3
  float half_density_friction = 0.0F;  ///< 1/2 rho C_t
  float time_per_density = 0.0F;       ///< the time the force is held over the cloth's density, in s m^2/kg
  float per_time_step = 0.0F;          ///< 1 / dt, in 1/s
};

/// A sparse matrix by rows, without its diagonal: with it every row would sum to zero. Each row has an even
/// number of entries, the last of which may be a 0.
struct RowMatrix {
  std::vector<std::uint32_t> begin;  ///< one more than there are rows
  std::vector<std::uint32_t> column;
  std::vector<float> value;
};

/// Where a tether can never be reached: as long as no cloth is.
inline constexpr float never_reached = 1e30F;

/// By row, each vertex's tether to a pin. All pins move alike.
struct TetherLanes {
  std::vector<Index> pin;       ///< row of the pin
  Rows start;                   ///< from the pin to the vertex when the frame began, in m
  Lanes<float> squared_length;  ///< in m^2; `never_reached` where there is no tether
};

/// The loops in which the time goes. Each does the same operations on every element in the same order,
/// whatever the width of the processor's vectors, so that all of them give the same bits; no fused
/// multiply-add, no approximate reciprocal, no approximate square root.
struct Kernels {
  /// Eq. (1) in displacements d since the frame's start, for rows [begin, end):
  ///   previous <- d + (d - previous) decay + a dt^2
  /// where `current` holds d. The caller then lets the two change places.
  void (*predict)(std::size_t begin, std::size_t end, float decay, float dt_squared, const Row* accelerations,
                  const Row* current, Row* previous);

  /// Eqs. (2)-(3) for blocks [begin, end) of one colour: springs that are too long are shortened to rest,
  /// those too short give back a part. With L' = L'_start + d_i - d_j the relative error is taken as
  /// (|L'|^2 - |L|^2) / (|L'|^2 + |L|^2), which is (|L'| - |L|) / |L'| to the second order in the error and
  /// never above 1, without a square root (Jakobsen 2001).
  void (*sweep)(const SpringLanes& springs, std::size_t begin, std::size_t end, Row* rows);

  /// Brings vertices of rows [begin, end), multiples of the block size, back to where their tethers end, by
  /// the same error. The pins have moved by `pin_moved` since the frame began.
  void (*hold)(const TetherLanes& tethers, std::size_t begin, std::size_t end, const Row& pin_moved,
               Row* rows);

  /// The same for springs longer than the bound alone: where |L'|^2 is above `squared_bound` |L|^2,
  /// `relaxation` times what is needed. Blocks without such a spring are left untouched.
  void (*shorten)(const SpringLanes& springs, std::size_t begin, std::size_t end, float squared_bound,
                  float relaxation, Row* rows);

  /// For each block [begin, end) the largest |L'|^2 / |L|^2 of its springs, into `squared_ratios` by block.
  void (*largest_ratios)(const SpringLanes& springs, std::size_t begin, std::size_t end, const Row* rows,
                         float* squared_ratios);

  /// A sixth of the doubled force of the air on each triangle of lanes [begin, end), a multiple of the block
  /// size: what each corner gets, in N. Positions are `start` + `current`; `previous` is one dt before.
  void (*wind)(const TriangleLanes& triangles, const AirFlow& air, std::size_t begin, std::size_t end,
               const Row* start, const Row* current, const Row* previous, Row* corner_forces);

  /// For rows [begin, end): result += sum over columns of value (x_column - x_row), even entries summed apart
  /// from odd ones, so that no sum waits for the one before it.
  void (*add_product)(const RowMatrix& matrix, std::size_t begin, std::size_t end, const Row* positions,
                      Row* result);
};

/// Throws std::invalid_argument on a unit this processor lacks.
const Kernels& kernels_for(VectorUnit unit);

}  // namespace taut::sim::bounded
