#include "sim/solvers/bounded/layout.hpp"

#include "sim/solvers/bounded/colouring.hpp"
#include "sim/solvers/bounded/surface_layout.hpp"

namespace taut::sim::bounded {
namespace {

std::size_t bound_spring_count(const Springs& springs) { return springs.begin_of(SpringKind::flexural); }

struct SpringInRows {
  Index row_i;
  Index row_j;
  Index spring;
};

/// Returns the springs with their ends as rows, the end nearer to the pins first. Springs between two pins
/// cannot be corrected and are left out.
std::vector<SpringInRows> movable_springs(const Springs& springs, const std::vector<bool>& is_left_out,
                                          const Layout& layout) {
  std::vector<SpringInRows> rows;
  for (Index s = 0; s < bound_spring_count(springs); ++s) {
    if (is_left_out[s]) continue;
    const auto [a, b] = springs.ends[s];
    const Index i = std::min(layout.row_of_vertex[a], layout.row_of_vertex[b]);
    const Index j = std::max(layout.row_of_vertex[a], layout.row_of_vertex[b]);
    if (j >= layout.pin_count) rows.push_back({i, j, s});
  }
  std::sort(rows.begin(), rows.end(), [](const SpringInRows& a, const SpringInRows& b) {
    return std::tie(a.row_i, a.row_j, a.spring) < std::tie(b.row_i, b.row_j, b.spring);
  });
  return rows;
}

/// Sets a lane to a spring between two rows.
void set_lane(SpringLanes& lanes, std::size_t lane, Index row_i, Index row_j, double share_i, double rest_m) {
  SpringBlock& block = lanes.blocks[lane / block_size];
  const std::size_t k = lane % block_size;
  block.at_i[k] = 4 * row_i;
  block.at_j[k] = 4 * row_j;
  block.share_i[k] = static_cast<float>(share_i);
  block.squared_rest[k] = static_cast<float>(rest_m * rest_m);
}

void append_colour(const std::vector<SpringInRows>& springs, const std::vector<std::size_t>& colour,
                   const Garment& garment, const Pins& pins, const Layout& layout, SpringLanes& lanes) {
  const std::size_t begin = lanes.lane_count();
  const std::size_t block_count = (colour.size() + block_size - 1) / block_size;
  lanes.blocks.resize(lanes.block_count() + block_count);
  lanes.spring.resize(begin + block_count * block_size, SpringLanes::no_spring);
  lanes.projection_share_i.resize(lanes.spring.size(), 0.0F);
  for (std::size_t k = 0; k < colour.size(); ++k) {
    const SpringInRows& s = springs[colour[k]];
    const double w_i = pins.inverse_masses_per_kg[layout.vertex_of_row[s.row_i]];
    const double w_j = pins.inverse_masses_per_kg[layout.vertex_of_row[s.row_j]];
    const double ratio = projection_ratio(s.row_i, s.row_j, layout);
    set_lane(lanes, begin + k, s.row_i, s.row_j, w_i / (w_i + w_j), garment.springs.rest_lengths_m[s.spring]);
    lanes.projection_share_i[begin + k] = static_cast<float>(w_i * ratio / (w_i * ratio + w_j));
    lanes.spring[begin + k] = s.spring;
  }
  for (std::size_t lane = begin + colour.size(); lane < lanes.lane_count(); ++lane) {
    const auto spare = static_cast<Index>(layout.vertex_count() + 2 * (lane % block_size));
    set_lane(lanes, lane, spare, spare + 1, 0.0, 1.0);
  }
  const auto end = static_cast<std::uint32_t>(lanes.block_count());
  lanes.sweep.push_back({static_cast<std::uint32_t>(end - block_count), end});
}

SpringLanes make_spring_lanes(const Garment& garment, const Pins& pins, const std::vector<bool>& is_left_out,
                              const Layout& layout) {
  const std::vector<SpringInRows> springs = movable_springs(garment.springs, is_left_out, layout);
  std::vector<std::array<Index, 2>> rows;
  for (const SpringInRows& s : springs) rows.push_back({s.row_i, s.row_j});
  SpringLanes lanes;
  for (const std::vector<std::size_t>& colour : coloured(rows, layout.vertex_count())) {
    append_colour(springs, colour, garment, pins, layout, lanes);
  }
  return lanes;
}

TriangleLanes make_triangle_lanes(const Garment& garment, const Layout& layout) {
  TriangleLanes lanes;
  const auto& triangles = garment.mesh.triangles;
  const std::size_t padded = (triangles.size() + block_size - 1) / block_size * block_size;
  const auto spare = static_cast<std::uint32_t>(layout.vertex_count());
  lanes.corner_begin.assign(layout.vertex_count() + 1, 0);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (const Triangle& t : triangles) {
      lanes.at[corner].push_back(4 * layout.row_of_vertex[t[corner]]);
      ++lanes.corner_begin[layout.row_of_vertex[t[corner]] + 1];
    }
    lanes.at[corner].resize(padded, 4 * spare);
  }
  std::partial_sum(lanes.corner_begin.begin(), lanes.corner_begin.end(), lanes.corner_begin.begin());
  lanes.corner_triangles.resize(3 * triangles.size());
  std::vector<std::uint32_t> next(lanes.corner_begin.begin(), lanes.corner_begin.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      lanes.corner_triangles[next[lanes.at[corner][t] / 4]++] = t;
    }
  }
  return lanes;
}

}  // namespace

void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start) {
  assert(positions_m.size() == layout.vertex_count());
  start.high.resize(layout.row_count());
  start.low.resize(layout.row_count());
  const Vec3 origin_m = positions_m[layout.vertex_of_row[0]];
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    start.high[row] = float4_of(positions_m[layout.vertex_of_row[row]] - origin_m);
  }
  // A separate loop: in one loop, GCC 12 at -O3 uses the values before rounding in place of the rounded ones.
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 from_origin_m = positions_m[layout.vertex_of_row[row]] - origin_m;
    start.low[row] = float4_of(from_origin_m - vector_of(start.high[row]));
  }
}

Layout make_layout(const Garment& garment, const Pins& pins, BoundKind bound) {
  Layout layout;
  static_cast<Rows&>(layout) = make_rows(garment, pins);
  std::vector<bool> is_held(garment.springs.size(), false);
  if (bound == BoundKind::surface) {
    layout.surface = make_surface_lanes(garment, pins, layout);
    is_held = springs_held_by_triangles(garment);
  }
  layout.springs = make_spring_lanes(garment, pins, is_held, layout);
  layout.triangles = make_triangle_lanes(garment, layout);
  return layout;
}

}  // namespace taut::sim::bounded
