#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// Blocks [begin, end) of one colour.
struct BlockRange {
  std::uint32_t begin;
  std::uint32_t end;
  /// The blocks were swept before in the same sweep. Then only long elements are corrected: the push of short ones is a
  /// force, which acts once per time step.
  bool is_repeat = false;
};

/// Data of `block_size` springs that a sweep reads, side by side in memory.
struct alignas(64) SpringBlock {
  template <typename T> using Of = std::array<T, block_size>;

  /// Offset of end i in floats: 4 times the solver index.
  Of<std::uint32_t> at_i;
  Of<std::uint32_t> at_j;
  /// Fraction of a correction that end i takes: w_i / (w_i + w_j) with the inverse masses w.
  Of<float> share_i;
  Of<float> squared_rest;  ///< |L|^2, in m^2
  /// Fraction of its error that a short spring corrects in one sweep.
  Of<float> short_share;
  /// L' = p'_i - p'_j at the start of the frame, in m.
  Of<float> start_x;
  Of<float> start_y;
  Of<float> start_z;
};

/// Bounded springs, structural and shear. Springs of one colour share no vertex, so they can be corrected all at once
/// with the same result as one by one. Each colour is padded to whole blocks with springs between padding entries,
/// which never move.
struct SpringLanes {
  Lanes<SpringBlock> blocks;
  /// share_i for the projection, in which vertices near pins have more weight.
  Lanes<float> projection_share_i;
  /// Index of the garment's spring per lane; no_spring in padding.
  std::vector<Index> spring;
  std::vector<BlockRange> sweep;  ///< colours in the order of one sweep

  static constexpr Index no_spring = ~Index{0};
  std::size_t lane_count() const { return spring.size(); }
  std::size_t block_count() const { return blocks.size(); }
  /// Return the solver index of each end of the spring in a lane.
  Index row_i(std::size_t lane) const { return blocks[lane / block_size].at_i[lane % block_size] / 4; }
  Index row_j(std::size_t lane) const { return blocks[lane / block_size].at_j[lane % block_size] / 4; }
};

/// Response of `block_size` triangles to a correction. With inverse masses w and the gradients g of their deformation
/// gradients F by their corners, corner k corrects a stretch along the unit vector v at rest, at the angle a to the
/// first axis, in proportion to
///   w_k (g_k v) / (sum of w (g v)^2).
/// Inverse masses are scaled so that the sum of w |g|^2 is 1; the divisor is then
///   1/2 + along_less_across cos 2a + skew sin 2a.
struct alignas(64) SurfaceMobility {
  std::array<std::array<float, block_size>, 3> corners;  ///< w, in m^2
  std::array<float, block_size> along_less_across;
  std::array<float, block_size> skew;
};

/// Data of `block_size` triangles that a sweep reads, side by side in memory. Entries with three elements have one for
/// each corner or coordinate.
struct alignas(64) SurfaceBlock {
  template <typename T> using Of = std::array<T, block_size>;

  /// Offset of each corner in floats.
  std::array<Of<std::uint32_t>, 3> at;
  SurfaceMobility mobility;
  /// See TriangleAtRest.
  Of<float> along_per_m;
  Of<float> across_per_m;
  Of<float> skew_per_m;
  /// Fraction of its error that a principal stretch below 1 corrects in one sweep.
  Of<float> short_share;
  /// Columns of F at the start of the frame.
  std::array<Of<float>, 3> start_along;
  std::array<Of<float>, 3> start_across;
};

/// Triangles with bounded stretch in every direction. Triangles of one colour share no vertex. Each colour is padded to
/// whole blocks with triangles at a padding entry, which never moves.
struct SurfaceLanes {
  Lanes<SurfaceBlock> blocks;
  /// Mobility for the projection, by block; there, vertices near pins have more weight.
  Lanes<SurfaceMobility> projection_mobility;
  /// Mobility of a triangle against compression per lane, in 1/kg: half the sum of w |g|^2 times the area; 0 in
  /// padding.
  std::vector<float> mobility_per_kg;
  std::vector<Index> triangle;  ///< index of the garment's triangle per lane; no_triangle in padding
  static constexpr Index no_triangle = ~Index{0};
  bool has_thin_triangles = false;  ///< some F have larger errors than single-precision lengths
  /// Fraction of its error that a long triangle corrects in one sweep. With one sweep per time step, values up to 4/3
  /// are stable.
  float relaxation = 1.0F;
  /// Order of one sweep: the colours, then again the part of each that is nearest to the pins.
  std::vector<BlockRange> sweep;

  std::size_t lane_count() const { return mobility_per_kg.size(); }
  std::size_t block_count() const { return blocks.size(); }
};

/// Sums over sweeps of the corrections of `block_size` triangles. Each correction changes F by F times a symmetric
/// matrix; the sum holds that matrix times the ratio of current to rest length. In the frame of the first edge; scaled
/// by time and mobility it is tension.
struct alignas(64) SurfaceSums {
  std::array<float, block_size> along = {};
  std::array<float, block_size> across = {};
  std::array<float, block_size> mixed = {};
};

/// All triangles of the garment, for the wind, padded to whole blocks with triangles without area.
struct TriangleLanes {
  /// Offset of each corner in floats, per corner and triangle.
  std::array<Lanes<std::uint32_t>, 3> at;
  /// The triangles of vertex r are corner_triangles from corner_begin[r] up to, not including, corner_begin[r + 1].
  std::vector<std::uint32_t> corner_begin;
  std::vector<std::uint32_t> corner_triangles;

  std::size_t lane_count() const { return at[0].size(); }
};

/// Positions at the start of a frame, in m, relative to one point of the cloth; one entry per solver index. `high` is
/// in single precision and `low` is its rounding error. Padding is zero.
struct StartRows {
  Float4Array high;
  Float4Array low;
};

/// Squared length of a tether that never acts, in m^2: longer than any cloth.
inline constexpr float unreachable_squared_m2 = 1e30F;

/// Tether of one vertex to a pin.
struct Tether {
  float start_x = 0.0F;  ///< vector from the pin to the vertex at the start of the frame, in m
  float start_y = 0.0F;
  float start_z = 0.0F;
  float squared_length = unreachable_squared_m2;  ///< squared length in m^2; `unreachable_squared_m2` without a tether
};

}  // namespace taut::sim::bounded
