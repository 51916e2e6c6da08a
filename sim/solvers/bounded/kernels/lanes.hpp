#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// Springs side by side, everything a sweep reads of them in one stretch of memory.
struct alignas(64) SpringBlock {
  template <typename T>
  using Of = std::array<T, block_size>;

  Of<std::uint32_t> at_i;  ///< where the row of end i begins, counted in floats: 4 times the row's number
  Of<std::uint32_t> at_j;
  Of<float> share_i;       ///< w_i / (w_i + w_j): the part of a correction that end i takes
  Of<float> squared_rest;  ///< |L|^2, in m^2
  Of<float> short_share;   ///< the part of its error that a spring too short corrects in one sweep
  Of<float> start_x;       ///< L' = p'_i - p'_j when the frame began, in m
  Of<float> start_y;
  Of<float> start_z;
};

/// The springs that are bound, structural and shear. Springs of one colour share no vertex, so that all of
/// them can be corrected at once with the result of correcting them one by one. Colours are filled up to
/// whole blocks with springs between spare rows, which never move.
struct SpringLanes {
  Lanes<SpringBlock> blocks;
  Lanes<float> projection_share_i;  ///< share_i in the projection, where vertices near pins weigh more
  std::vector<Index> spring;        ///< the garment's spring in each lane; no_spring in padding
  std::vector<std::uint32_t> colour_begin;  ///< in blocks; colour c is [colour_begin[c], colour_begin[c + 1])

  static constexpr Index no_spring = ~Index{0};
  std::size_t lane_count() const { return spring.size(); }
  std::size_t block_count() const { return blocks.size(); }
  std::size_t colour_count() const { return colour_begin.size() - 1; }
  Index row_i(std::size_t lane) const { return blocks[lane / block_size].at_i[lane % block_size] / 4; }
  Index row_j(std::size_t lane) const { return blocks[lane / block_size].at_j[lane % block_size] / 4; }
};

/// The triangles the wind blows at, padded to whole blocks with triangles of no area.
struct TriangleLanes {
  std::array<Lanes<std::uint32_t>, 3> at;   ///< of each corner, where its row begins, counted in floats
  std::vector<std::uint32_t> corner_begin;  ///< the triangles of row r: corner_triangles from corner_begin[r]
  std::vector<std::uint32_t> corner_triangles;

  std::size_t lane_count() const { return at[0].size(); }
};

/// Where the cloth is when a frame begins, by row, from a point of it: in single precision, and what that
/// rounds away. Spare rows are zero.
struct StartRows {
  Float4Array high;
  Float4Array low;
};

/// Where a tether can never be reached: as long as no cloth is.
inline constexpr float never_reached = 1e30F;

struct Tether {
  float start_x = 0.0F;  ///< from the pin to the vertex when the frame began, in m
  float start_y = 0.0F;
  float start_z = 0.0F;
  float squared_length = never_reached;  ///< in m^2; `never_reached` where there is none
};

}  // namespace taut::sim::bounded
