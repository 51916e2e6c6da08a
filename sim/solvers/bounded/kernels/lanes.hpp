#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// Blocks [begin, end), which are all of one colour.
struct BlockRange {
  std::uint32_t begin;
  std::uint32_t end;
  /// They were swept before in the same sweep. Only what is too long is corrected then: the push of what is
  /// too short is a force, which acts once in a time step.
  bool again = false;
};

/// The data of `block_size` springs that a sweep reads, side by side in memory.
struct alignas(64) SpringBlock {
  template <typename T> using Of = std::array<T, block_size>;

  /// Where the row of end i begins, counted in floats: 4 times the index of the row.
  Of<std::uint32_t> at_i;
  Of<std::uint32_t> at_j;
  /// w_i / (w_i + w_j) with the inverse masses w: the fraction of a correction that end i takes.
  Of<float> share_i;
  Of<float> squared_rest;  ///< |L|^2, in m^2
  /// The fraction of its error that a spring corrects in one sweep when it is too short.
  Of<float> short_share;
  /// L' = p'_i - p'_j at the start of the frame, in m.
  Of<float> start_x;
  Of<float> start_y;
  Of<float> start_z;
};

/// The springs with a bound on their stretch, structural and shear. Springs of one colour share no vertex. So
/// they can be corrected all at once, with the same result as one by one. Each colour is filled up to whole
/// blocks with padding: springs between spare rows, which never move.
struct SpringLanes {
  Lanes<SpringBlock> blocks;
  /// The share_i that the projection uses; there, vertices near pins have more weight.
  Lanes<float> projection_share_i;
  /// Per lane the garment's spring; no_spring in padding.
  std::vector<Index> spring;
  std::vector<BlockRange> sweep;  ///< in the order of one sweep: the colours

  static constexpr Index no_spring = ~Index{0};
  std::size_t lane_count() const { return spring.size(); }
  std::size_t block_count() const { return blocks.size(); }
  /// The row of end i of the spring in a lane; row_j that of end j.
  Index row_i(std::size_t lane) const { return blocks[lane / block_size].at_i[lane % block_size] / 4; }
  Index row_j(std::size_t lane) const { return blocks[lane / block_size].at_j[lane % block_size] / 4; }
};

/// How `block_size` triangles answer a correction. With inverse masses w and the gradients g of their
/// deformation gradients F by their corners, a stretch along the unit vector v at rest, at the angle a to the
/// first axis, is corrected by corner k in proportion to
///   w_k (g_k v) / (sum of w (g v)^2).
/// Inverse masses are scaled so that the sum of w |g|^2 is 1; the divisor is then
///   1/2 + along_less_across cos 2a + skew sin 2a.
struct alignas(64) SurfaceMobility {
  std::array<std::array<float, block_size>, 3> corners;  ///< w, in m^2
  std::array<float, block_size> along_less_across;
  std::array<float, block_size> skew;
};

/// The data of `block_size` triangles that a sweep reads, side by side in memory. Entries with three elements
/// have one for each corner, or one for each coordinate.
struct alignas(64) SurfaceBlock {
  template <typename T> using Of = std::array<T, block_size>;

  /// Where the row of each corner begins, counted in floats.
  std::array<Of<std::uint32_t>, 3> at;
  SurfaceMobility mobility;
  /// See TriangleAtRest.
  Of<float> along_per_m;
  Of<float> across_per_m;
  Of<float> skew_per_m;
  /// The fraction of its error that a principal stretch below 1 corrects in one sweep.
  Of<float> short_share;
  /// The columns of F at the start of the frame.
  std::array<Of<float>, 3> start_along;
  std::array<Of<float>, 3> start_across;
};

/// The triangles with a bound on their stretch in every direction. Triangles of one colour share no vertex.
/// Each colour is filled up to whole blocks with padding: triangles at a spare row, which never moves.
struct SurfaceLanes {
  Lanes<SurfaceBlock> blocks;
  /// By block, as the projection has it; there, vertices near pins have more weight.
  Lanes<SurfaceMobility> projection_mobility;
  /// Per lane half the sum of w |g|^2 times the area, in 1/kg: the mobility of a triangle against
  /// compression; 0 in padding.
  std::vector<float> mobility_per_kg;
  std::vector<Index> triangle;  ///< per lane the garment's; no_triangle in padding
  static constexpr Index no_triangle = ~Index{0};
  bool has_thin = false;  ///< some triangles' F is wrong by more than lengths are in single precision
  /// The part of the error of what is too long that a sweep corrects. In time steps with one sweep each up to 4/3
  /// is stable.
  float relaxation = 1.0F;
  /// In the order of one sweep: the colours, and then again the part of each that is nearest to the pins.
  std::vector<BlockRange> sweep;

  std::size_t lane_count() const { return mobility_per_kg.size(); }
  std::size_t block_count() const { return blocks.size(); }
};

/// Sums over sweeps of the corrections of `block_size` triangles: each changed F by F times a symmetric matrix,
/// here times the length of the triangle in units of its rest. In the frame of the first edge; scaled by time
/// and mobility it is tension.
struct alignas(64) SurfaceSums {
  std::array<float, block_size> along = {};
  std::array<float, block_size> across = {};
  std::array<float, block_size> mixed = {};
};

/// All triangles of the garment, for the wind. They are padded to whole blocks with triangles without area.
struct TriangleLanes {
  /// Per corner and triangle, where the row of the corner begins, counted in floats.
  std::array<Lanes<std::uint32_t>, 3> at;
  /// The triangles at row r are corner_triangles from corner_begin[r] up to, not including, corner_begin[r +
  /// 1].
  std::vector<std::uint32_t> corner_begin;
  std::vector<std::uint32_t> corner_triangles;

  std::size_t lane_count() const { return at[0].size(); }
};

/// The positions at the start of a frame, in m, relative to one point of the cloth; one entry per row. `high`
/// is in single precision and `low` is what that rounds off. Spare rows are zero.
struct StartRows {
  Float4Array high;
  Float4Array low;
};

/// The squared length of a tether that never acts, in m^2: longer than any cloth.
inline constexpr float never_reached = 1e30F;

/// One vertex's tether to a pin.
struct Tether {
  float start_x = 0.0F;  ///< from the pin to the vertex at the start of the frame, in m
  float start_y = 0.0F;
  float start_z = 0.0F;
  float squared_length = never_reached;  ///< in m^2; `never_reached` without a tether
};

}  // namespace taut::sim::bounded
