#include "sim/solvers/bounded/layout.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "sim/mesh/elementary.hpp"
#include "sim/mesh/geodesics.hpp"
#include "sim/solvers/bounded/colouring.hpp"
#include "sim/solvers/bounded/surface_layout.hpp"

namespace taut::sim::bounded {
namespace {

/// In the projection, weights grow by this power of e per spring towards the pins. A larger value hands
/// corrections down the cloth faster and leaves smaller ones near the pins.
constexpr double projection_weight_growth = 0.2;

std::size_t bound_spring_count(const Springs& springs) {
  return springs.begin_of(SpringKind::flexural);
}

void number_rows(const Garment& garment, const Pins& pins, Layout& layout) {
  const GeodesicDistances geodesics = geodesic_distances(garment.mesh, garment.adjacency, pins.vertices);
  const std::vector<double>& distances_m = geodesics.distances_m;
  std::vector<Index>& order = layout.vertex_of_row;
  order.resize(distances_m.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return distances_m[a] < distances_m[b]; });
  layout.row_of_vertex.resize(order.size());
  for (Index row = 0; row < order.size(); ++row) {
    layout.row_of_vertex[order[row]] = row;
    layout.distance_from_pins_m.push_back(distances_m[order[row]]);
    layout.inverse_masses_per_kg.push_back(static_cast<float>(pins.inverse_masses_per_kg[order[row]]));
  }
  for (const Index v : order) {
    const Index pin = geodesics.nearest_sources[v];
    layout.nearest_pin_row.push_back(pin == GeodesicDistances::no_source ? 0 : layout.row_of_vertex[pin]);
  }
  layout.inverse_masses_per_kg.resize(layout.row_count(), 0.0F);
  layout.pin_count = pins.vertices.size();
}

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
    if (is_left_out[s]) {
      continue;
    }
    const auto [a, b] = springs.ends[s];
    const Index i = std::min(layout.row_of_vertex[a], layout.row_of_vertex[b]);
    const Index j = std::max(layout.row_of_vertex[a], layout.row_of_vertex[b]);
    if (j >= layout.pin_count) {
      rows.push_back({i, j, s});
    }
  }
  std::sort(rows.begin(), rows.end(), [](const SpringInRows& a, const SpringInRows& b) {
    return std::tie(a.row_i, a.row_j) < std::tie(b.row_i, b.row_j);
  });
  return rows;
}

void measure_reach(const Garment& garment, Layout& layout) {
  const std::size_t count = bound_spring_count(garment.springs);
  for (const double distance_m : layout.distance_from_pins_m) {
    layout.reach_m = std::isfinite(distance_m) ? std::max(layout.reach_m, distance_m) : layout.reach_m;
  }
  double total_m = 0.0;
  for (std::size_t s = 0; s < count; ++s) {
    total_m += garment.springs.rest_lengths_m[s];
  }
  layout.reach_springs = total_m > 0.0 ? layout.reach_m * static_cast<double>(count) / total_m : 0.0;
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
  for (const SpringInRows& s : springs) {
    rows.push_back({s.row_i, s.row_j});
  }
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

double projection_ratio(Index row_i, Index row_j, const Layout& layout) {
  const double further_m = layout.distance_from_pins_m[row_j] - layout.distance_from_pins_m[row_i];
  if (!std::isfinite(further_m) || !(layout.reach_m > 0.0)) {
    return 1.0;
  }
  return exponential(-projection_weight_growth * further_m * layout.reach_springs / layout.reach_m);
}

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
  number_rows(garment, pins, layout);
  measure_reach(garment, layout);
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
