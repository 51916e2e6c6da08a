#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/garment.hpp"
#include "sim/solvers/bounded/rows.hpp"

namespace taut::sim::bounded {

/// Springs, or triangles, are worked on in blocks of this many, whatever number the processor's vectors hold:
/// a block is the unit of padding, of choosing and of sharing work among threads.
inline constexpr std::size_t block_size = 16;

/// The springs that are bound, structural and shear, as a structure of arrays. Springs of one colour share no
/// vertex, so that all of them can be corrected at once with the result of correcting them one by one.
/// Colours are filled up to whole blocks with springs between spare rows, which never move.
struct SpringLanes {
  Lanes<std::uint32_t> row_i;
  Lanes<std::uint32_t> row_j;
  Lanes<float> share_i;       ///< w_i / (w_i + w_j): the part of a correction that end i takes
  Lanes<float> squared_rest;  ///< |L|^2, in m^2
  Lanes<float> short_share;   ///< the part of its error that a spring too short corrects in one sweep
  Lanes<float> start_x;       ///< L' = p'_i - p'_j when the frame began, in m
  Lanes<float> start_y;
  Lanes<float> start_z;
  std::vector<Index> spring;                ///< the garment's spring in each lane; no_spring in padding
  std::vector<std::uint32_t> colour_begin;  ///< in blocks; colour c is [colour_begin[c], colour_begin[c + 1])

  static constexpr Index no_spring = ~Index{0};
  std::size_t lane_count() const { return row_i.size(); }
  std::size_t block_count() const { return lane_count() / block_size; }
  std::size_t colour_count() const { return colour_begin.size() - 1; }
};

/// The triangles the wind blows at, padded to whole blocks with triangles of no area.
struct TriangleLanes {
  std::array<Lanes<std::uint32_t>, 3> row;
  std::vector<std::uint32_t> corner_begin;  ///< the triangles of row r: corner_triangles from corner_begin[r]
  std::vector<std::uint32_t> corner_triangles;

  std::size_t lane_count() const { return row[0].size(); }
};

/// A garment as the solver wants it: one row for each vertex, in the order of the distance from the pins
/// along the cloth, which keeps rows that work together near each other; the pins are the first rows.
struct Layout {
  std::vector<Index> vertex_of_row;
  std::vector<Index> row_of_vertex;
  std::vector<float> inverse_masses_per_kg;  ///< by row; 0 for spare rows
  std::vector<double>
      distance_from_pins_m;  ///< by row, along mesh edges; infinite where no pin can be reached
  std::size_t pin_count = 0;
  SpringLanes springs;
  TriangleLanes triangles;

  std::size_t vertex_count() const { return vertex_of_row.size(); }
  /// Vertices and the spare rows of padding lanes.
  std::size_t row_count() const { return vertex_count() + 2 * block_size; }
};

Layout make_layout(const Garment& garment);

/// Along the springs that are bound, for every vertex (Dijkstra 1959); infinite where no pin can be reached.
std::vector<double> distances_from_pins(const Garment& garment);

}  // namespace taut::sim::bounded
