#include "sim/solvers/bounded/layout.hpp"

#include "sim/mesh/elementary.hpp"
#include "sim/mesh/geodesics.hpp"
#include "sim/solvers/bounded/kernels/blocks.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// Greedy colouring: each element gets the first colour that no earlier element at its vertices has. An element is the
/// `corners` vertices that it moves. Returns the element indices of each colour, in order.
template <std::size_t corners>
std::vector<std::vector<std::size_t>> colour_greedily(const std::vector<std::array<Index, corners>>& elements,
                                                      std::size_t row_count) {
  std::vector<std::vector<std::size_t>> colours;
  std::vector<std::vector<bool>> is_taken;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::array<Index, corners>& rows = elements[e];
    std::size_t c = 0;
    while (c < colours.size() && std::any_of(rows.begin(), rows.end(), [&](Index row) { return is_taken[c][row]; })) {
      ++c;
    }
    if (c == colours.size()) {
      colours.emplace_back();
      is_taken.emplace_back(row_count, false);
    }
    colours[c].push_back(e);
    for (const Index row : rows) is_taken[c][row] = true;
  }
  return colours;
}

void number_rows(const Garment& garment, const Pins& pins, SolverOrder& rows) {
  const GeodesicDistances geodesics = geodesic_distances(garment.mesh, garment.adjacency, pins.vertices);
  const std::vector<double>& distances_m = geodesics.distances_m;
  std::vector<Index>& order = rows.vertex_indices;
  order.resize(distances_m.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return distances_m[a] < distances_m[b]; });
  rows.solver_indices.resize(order.size());
  for (Index row = 0; row < order.size(); ++row) {
    rows.solver_indices[order[row]] = row;
    rows.distance_from_pins_m.push_back(distances_m[order[row]]);
    rows.inverse_masses_per_kg.push_back(static_cast<float>(pins.inverse_masses_per_kg[order[row]]));
  }
  for (const Index v : order) {
    const Index pin = geodesics.nearest_sources[v];
    rows.nearest_pin_row.push_back(pin == GeodesicDistances::no_source ? 0 : rows.solver_indices[pin]);
  }
  rows.inverse_masses_per_kg.resize(rows.row_count(), 0.0F);
  rows.pin_count = pins.vertices.size();
}

void measure_reach(const Garment& garment, SolverOrder& rows) {
  const std::size_t count = garment.springs.begin_index(SpringKind::flexural);
  for (const double distance_m : rows.distance_from_pins_m) {
    rows.reach_m = std::isfinite(distance_m) ? std::max(rows.reach_m, distance_m) : rows.reach_m;
  }
  double total_m = 0.0;
  for (std::size_t s = 0; s < count; ++s) total_m += garment.springs.rest_lengths_m[s];
  rows.reach_springs = total_m > 0.0 ? rows.reach_m * static_cast<double>(count) / total_m : 0.0;
}

std::size_t bound_spring_count(const Springs& springs) { return springs.begin_index(SpringKind::flexural); }

struct SpringInRows {
  Index row_i;
  Index row_j;
  Index spring;
};

/// Returns the springs with their ends as solver indices, the end nearer to the pins first. Springs between two pins
/// cannot be corrected and are left out.
std::vector<SpringInRows> movable_springs(const Springs& springs, const std::vector<bool>& is_left_out,
                                          const Layout& layout) {
  assert(is_left_out.empty() || is_left_out.size() == springs.ends.size());
  std::vector<SpringInRows> rows;
  for (Index s = 0; s < bound_spring_count(springs); ++s) {
    if (is_left_out[s]) continue;
    const auto [a, b] = springs.ends[s];
    const Index i = std::min(layout.solver_indices[a], layout.solver_indices[b]);
    const Index j = std::max(layout.solver_indices[a], layout.solver_indices[b]);
    if (j >= layout.pin_count) rows.push_back({i, j, s});
  }
  std::sort(rows.begin(), rows.end(), [](const SpringInRows& a, const SpringInRows& b) {
    return std::tie(a.row_i, a.row_j, a.spring) < std::tie(b.row_i, b.row_j, b.spring);
  });
  return rows;
}

/// Sets a lane to a spring between two solver indices.
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
    const double w_i = pins.inverse_masses_per_kg[layout.vertex_indices[s.row_i]];
    const double w_j = pins.inverse_masses_per_kg[layout.vertex_indices[s.row_j]];
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
  for (const std::vector<std::size_t>& colour : colour_greedily(rows, layout.vertex_count())) {
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
      lanes.at[corner].push_back(4 * layout.solver_indices[t[corner]]);
      ++lanes.corner_begin[layout.solver_indices[t[corner]] + 1];
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

/// Largest distance between a flat cell's diagonals, as a fraction of the length of one. The path along the cell from
/// corner to corner then exceeds the diagonal by at most the square of it.
constexpr double max_flatness_error = 1e-5;

bool is_flat(const Mesh& mesh, const Quad& cell) {
  const auto at = [&](std::size_t k) { return mesh.positions[cell[k]]; };
  const Vec3 one = at(2) - at(0);
  const Vec3 other = at(3) - at(1);
  const Vec3 normal = glm::cross(one, other);
  const double apart_m = std::abs(glm::dot(normal, at(1) - at(0)));
  return apart_m <= max_flatness_error * glm::length(one) * glm::length(normal);
}

// Triangles near the pins carry all cloth below, and their error grows with their load. Without repeated sweeps, a
// shirt in a wind of 10 m/s takes twice the time.
void sweep_again_near_pins(double first_part, SurfaceLanes& lanes) {
  assert(first_part >= 0.0);
  const std::vector<BlockRange> colours = lanes.sweep;
  for (double part = first_part; part > tuning::min_resweep_fraction; part *= tuning::resweep_fraction) {
    for (const BlockRange& colour : colours) {
      const auto count = static_cast<std::uint32_t>(std::ceil(part * (colour.end - colour.begin)));
      lanes.sweep.push_back({colour.begin, colour.begin + count, true});
    }
  }
}

class SpringFinder {
 public:
  explicit SpringFinder(const Springs& springs) : springs_(springs) {}

  /// Calls mark(s) for each bounded spring s between a and b.
  template <typename Mark> void find(Index a, Index b, const Mark& mark) const {
    const Edge edge = {std::min(a, b), std::max(a, b)};
    for (const SpringKind kind : {SpringKind::structural, SpringKind::shear}) {
      const auto first = springs_.ends.begin() + static_cast<std::ptrdiff_t>(springs_.begin_index(kind));
      const auto last = springs_.ends.begin() + static_cast<std::ptrdiff_t>(springs_.end_index(kind));
      const auto found = std::lower_bound(first, last, edge);
      if (found != last && *found == edge) mark(static_cast<std::size_t>(found - springs_.ends.begin()));
    }
  }

 private:
  const Springs& springs_;
};

/// Ratio of edge to height above which a triangle is thin. Rounding of edges is amplified by this ratio.
constexpr double max_aspect = 8.0;

bool is_thin(const TriangleAtRest& rest) {
  const double max_per_m = std::max(rest.across_per_m, std::abs(rest.skew_per_m));
  return max_per_m > max_aspect * rest.along_per_m;
}

using TriangleRows = std::array<Index, 3>;

struct TriangleInRows {
  TriangleRows corners;  ///< solver indices
  Index triangle;
};

std::vector<TriangleInRows> movable_triangles(const Garment& garment, const SolverOrder& rows) {
  std::vector<TriangleInRows> movable;
  for (Index t = 0; t < garment.mesh.triangles.size(); ++t) {
    TriangleRows corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = rows.solver_indices[garment.mesh.triangles[t][k]];
    if (garment.triangles_at_rest[t].has_surface() &&
        *std::max_element(corners.begin(), corners.end()) >= rows.pin_count) {
      movable.push_back({corners, t});
    }
  }
  const auto sorted = [](TriangleRows corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::stable_sort(movable.begin(), movable.end(), [&](const TriangleInRows& a, const TriangleInRows& b) {
    return sorted(a.corners) < sorted(b.corners);
  });
  return movable;
}

/// Sums over the corners of weighted products of gradients: the matrix G of v^T G v = sum of w (g v)^2.
struct SquaredGradients {
  double along = 0.0;
  double across = 0.0;
  double mixed = 0.0;

  double trace() const { return along + across; }
};

SquaredGradients squared_gradients(const TriangleAtRest& rest, const std::array<double, 3>& inverse_masses) {
  SquaredGradients sums;
  const std::array<Vec2, 3> gradients = gradients_by_corners(rest);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vec2& g = gradients[corner];
    sums.along += inverse_masses[corner] * g.x * g.x;
    sums.across += inverse_masses[corner] * g.y * g.y;
    sums.mixed += inverse_masses[corner] * g.x * g.y;
  }
  return sums;
}

void set_mobility(const SquaredGradients& sums, const std::array<double, 3>& inverse_masses, std::size_t k,
                  SurfaceMobility& mobility) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    mobility.corners[corner][k] = static_cast<float>(inverse_masses[corner] / sums.trace());
  }
  mobility.along_less_across[k] = static_cast<float>(0.5 * (sums.along - sums.across) / sums.trace());
  mobility.skew[k] = static_cast<float>(sums.mixed / sums.trace());
}

/// Returns the corners' inverse weights in the projection, relative to the inverse masses; see projection_ratio.
std::array<double, 3> projection_weights(const std::array<double, 3>& inverse_masses, const TriangleRows& corners,
                                         const SolverOrder& rows) {
  std::array<double, 3> inverse_weights = inverse_masses;
  const Index nearest_row = *std::min_element(corners.begin(), corners.end());
  for (std::size_t k = 0; k < 3; ++k) inverse_weights[k] /= projection_ratio(nearest_row, corners[k], rows);
  return inverse_weights;
}

class SurfaceMaker {
 public:
  SurfaceMaker(const Garment& garment, const Pins& pins, const SolverOrder& rows)
      : garment_(garment), pins_(pins), rows_(rows) {}

  void append_colour(const std::vector<TriangleInRows>& triangles, const std::vector<std::size_t>& colour) {
    const std::size_t begin = lanes_.lane_count();
    const std::size_t end = begin + (colour.size() + block_size - 1) / block_size * block_size;
    lanes_.blocks.resize(end / block_size);
    lanes_.mobility_per_kg.resize(end, 0.0F);
    lanes_.triangle.resize(end, SurfaceLanes::no_triangle);
    lanes_.projection_mobility.resize(lanes_.block_count());
    for (std::size_t lane = begin; lane < end; ++lane) {
      if (lane - begin < colour.size()) {
        set_lane(lane, triangles[colour[lane - begin]]);
      } else {
        pad_lane(lane);
      }
    }
    lanes_.sweep.push_back(
        {static_cast<std::uint32_t>(begin / block_size), static_cast<std::uint32_t>(end / block_size)});
  }

  SurfaceLanes take() { return std::move(lanes_); }

 private:
  void set_lane(std::size_t lane, const TriangleInRows& t) {
    SurfaceBlock& block = lanes_.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    const TriangleAtRest& rest = garment_.triangles_at_rest[t.triangle];
    std::array<double, 3> inverse_masses{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      block.at[corner][k] = 4 * t.corners[corner];
      inverse_masses[corner] = pins_.inverse_masses_per_kg[rows_.vertex_indices[t.corners[corner]]];
    }
    block.along_per_m[k] = static_cast<float>(rest.along_per_m);
    block.across_per_m[k] = static_cast<float>(rest.across_per_m);
    block.skew_per_m[k] = static_cast<float>(rest.skew_per_m);
    const SquaredGradients sums = squared_gradients(rest, inverse_masses);
    lanes_.has_thin_triangles = lanes_.has_thin_triangles || is_thin(rest);
    set_mobility(sums, inverse_masses, k, block.mobility);
    const std::array<double, 3> weights = projection_weights(inverse_masses, t.corners, rows_);
    set_mobility(squared_gradients(rest, weights), weights, k, lanes_.projection_mobility[lane / block_size]);
    const double area_m2 = 0.5 / (rest.along_per_m * rest.across_per_m);
    lanes_.triangle[lane] = t.triangle;
    lanes_.mobility_per_kg[lane] = static_cast<float>(0.5 * sums.trace() * area_m2);
  }

  void pad_lane(std::size_t lane) {
    for (SurfaceBlock::Of<std::uint32_t>& at : lanes_.blocks[lane / block_size].at) {
      at[lane % block_size] = static_cast<std::uint32_t>(4 * (rows_.vertex_count() + lane % block_size));
    }
  }

  const Garment& garment_;
  const Pins& pins_;
  const SolverOrder& rows_;
  SurfaceLanes lanes_;
};

}  // namespace

std::size_t SolverOrder::row_count() const { return (vertex_count() + 3 * block_size - 1) / block_size * block_size; }

SolverOrder make_rows(const Garment& garment, const Pins& pins) {
  SolverOrder rows;
  number_rows(garment, pins, rows);
  measure_reach(garment, rows);
  return rows;
}

double projection_ratio(Index row_i, Index row_j, const SolverOrder& rows) {
  const double further_m = rows.distance_from_pins_m[row_j] - rows.distance_from_pins_m[row_i];
  if (!std::isfinite(further_m) || !(rows.reach_m > 0.0)) return 1.0;
  return exponential(-tuning::projection_weight_growth * further_m * rows.reach_springs / rows.reach_m);
}

void set_start(const Layout& layout, std::span<const Vec3> positions_m, StartRows& start) {
  assert(positions_m.size() == layout.vertex_count());
  start.high.resize(layout.row_count());
  start.low.resize(layout.row_count());
  const Vec3 origin_m = positions_m[layout.vertex_indices[0]];
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    start.high[row] = to_float4(positions_m[layout.vertex_indices[row]] - origin_m);
  }
  // A separate loop: in one loop, GCC 12 at -O3 uses the unrounded values in place of the rounded ones.
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 from_origin_m = positions_m[layout.vertex_indices[row]] - origin_m;
    start.low[row] = to_float4(from_origin_m - to_vec3(start.high[row]));
  }
}

Layout make_layout(const Garment& garment, const Pins& pins, BoundKind bound) {
  assert(pins.inverse_masses_per_kg.size() == garment.mesh.positions.size());
  Layout layout;
  static_cast<SolverOrder&>(layout) = make_rows(garment, pins);
  std::vector<bool> is_held(garment.springs.size(), false);
  if (bound == BoundKind::surface) {
    layout.surface = make_surface_lanes(garment, pins, layout);
    is_held = springs_held_by_triangles(garment);
  }
  layout.springs = make_spring_lanes(garment, pins, is_held, layout);
  layout.triangles = make_triangle_lanes(garment, layout);
  return layout;
}

std::vector<bool> springs_held_by_triangles(const Garment& garment) {
  std::vector<bool> held(garment.springs.size(), false);
  const SpringFinder springs(garment.springs);
  const auto mark = [&](std::size_t s) { held[s] = true; };
  const auto has_surface = [&](std::size_t t) { return garment.triangles_at_rest[t].has_surface(); };
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = garment.mesh.triangles[t];
    if (has_surface(t)) {
      springs.find(a, b, mark);
      springs.find(b, c, mark);
      springs.find(c, a, mark);
    }
  }
  for (std::size_t q = 0; q < garment.mesh.quads.size(); ++q) {
    const Quad& cell = garment.mesh.quads[q];
    if (has_surface(2 * q) && has_surface(2 * q + 1) && is_flat(garment.mesh, cell)) {
      springs.find(cell[0], cell[2], mark);
      springs.find(cell[1], cell[3], mark);
    }
  }
  return held;
}

SurfaceLanes make_surface_lanes(const Garment& garment, const Pins& pins, const SolverOrder& rows) {
  assert(pins.inverse_masses_per_kg.size() == garment.mesh.positions.size());
  const std::vector<TriangleInRows> triangles = movable_triangles(garment, rows);
  std::vector<TriangleRows> corners;
  for (const TriangleInRows& t : triangles) corners.push_back(t.corners);
  SurfaceMaker maker(garment, pins, rows);
  for (const std::vector<std::size_t>& colour : colour_greedily(corners, rows.vertex_count())) {
    maker.append_colour(triangles, colour);
  }
  SurfaceLanes lanes = maker.take();
  // The longest triangles of fine cloth are at the ends of folds, anywhere: fewer are swept again, and all are
  // corrected more.
  const bool is_fine = triangles.size() >= tuning::min_fine_triangles;
  if (is_fine) lanes.relaxation = tuning::fine_relaxation;
  const double first_part = is_fine ? tuning::resweep_fraction * tuning::resweep_fraction : tuning::resweep_fraction;
  if (rows.pin_count > 0) sweep_again_near_pins(first_part, lanes);
  return lanes;
}

}  // namespace taut::sim::bounded
