#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/pins.hpp"
#include "sim/solvers/bounded/kernels/rows.hpp"

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
  Lanes<float> certificate_share_i;  ///< share_i in the certificate, where vertices near pins weigh more
  std::vector<Index> spring;         ///< the garment's spring in each lane; no_spring in padding
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

/// A garment as the solver wants it: one row for each vertex, in the order of the distance from the pins
/// along the cloth, which keeps rows that work together near each other; the pins are the first rows.
struct Layout {
  std::vector<Index> vertex_of_row;
  std::vector<Index> row_of_vertex;
  std::vector<float> inverse_masses_per_kg;  ///< by row; 0 for spare rows
  std::vector<double>
      distance_from_pins_m;            ///< by row, along the cloth; infinite where no pin can be reached
  std::vector<Index> nearest_pin_row;  ///< by row; 0 where no pin can be reached
  std::size_t pin_count = 0;
  SpringLanes springs;
  TriangleLanes triangles;
  double reach_m = 0.0;        ///< the largest distance from the pins
  double reach_springs = 0.0;  ///< the same counted in springs of mean length

  std::size_t vertex_count() const { return vertex_of_row.size(); }
  /// Vertices and the spare rows of padding lanes, whole blocks.
  std::size_t row_count() const { return (vertex_count() + 3 * block_size - 1) / block_size * block_size; }
};

Layout make_layout(const Garment& garment, const Pins& pins);

/// Where the cloth is when a frame begins, by row, from a point of it: in single precision, and what that
/// rounds away. Spare rows are zero.
struct StartRows {
  Rows high;
  Rows low;
};

/// From positions by vertex, in m.
void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start);

}  // namespace taut::sim::bounded
