#include "sim/solvers/bounded/surface_layout.hpp"

#include "sim/solvers/bounded/colouring.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// The largest distance of a cell's diagonals from each other, in parts of the length of one. The way along
/// the cell from corner to corner is then longer than the diagonal by the square of it at most.
constexpr double flat = 1e-5;

bool is_flat(const Mesh& mesh, const Quad& cell) {
  const auto at = [&](std::size_t k) { return mesh.positions[cell[k]]; };
  const Vec3 one = at(2) - at(0);
  const Vec3 other = at(3) - at(1);
  const Vec3 normal = glm::cross(one, other);
  const double apart_m = std::abs(glm::dot(normal, at(1) - at(0)));
  return apart_m <= flat * glm::length(one) * glm::length(normal);
}

// Triangles near the pins carry all that hangs below, and their error grows with their load. Without this, a
// shirt in a wind of 10 m/s takes twice the time.
void sweep_again_near_pins(double first_part, SurfaceLanes& lanes) {
  const std::vector<BlockRange> colours = lanes.sweep;
  for (double part = first_part; part > tuning::few; part *= tuning::swept_again) {
    for (const BlockRange& colour : colours) {
      const auto count = static_cast<std::uint32_t>(std::ceil(part * (colour.end - colour.begin)));
      lanes.sweep.push_back({colour.begin, colour.begin + count, true});
    }
  }
}

class SpringFinder {
 public:
  explicit SpringFinder(const Springs& springs) : springs_(springs) {}

  /// Calls mark(s) for each bound spring s between a and b.
  template <typename Mark> void find(Index a, Index b, const Mark& mark) const {
    const Edge edge = {std::min(a, b), std::max(a, b)};
    for (const SpringKind kind : {SpringKind::structural, SpringKind::shear}) {
      const auto first = springs_.ends.begin() + static_cast<std::ptrdiff_t>(springs_.begin_of(kind));
      const auto last = springs_.ends.begin() + static_cast<std::ptrdiff_t>(springs_.end_of(kind));
      const auto found = std::lower_bound(first, last, edge);
      if (found != last && *found == edge) mark(static_cast<std::size_t>(found - springs_.ends.begin()));
    }
  }

 private:
  const Springs& springs_;
};

/// Edges over the height that they are divided by. The rounding of edges grows by as much.
constexpr double thin = 8.0;

bool is_thin(const TriangleAtRest& rest) {
  const double longest = std::max(rest.across_per_m, std::abs(rest.skew_per_m));
  return longest > thin * rest.along_per_m;
}

using Corners = std::array<Index, 3>;

struct TriangleInRows {
  Corners corners;  ///< as rows
  Index triangle;
};

std::vector<TriangleInRows> movable_triangles(const Garment& garment, const Rows& rows) {
  std::vector<TriangleInRows> movable;
  for (Index t = 0; t < garment.mesh.triangles.size(); ++t) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = rows.row_of_vertex[garment.mesh.triangles[t][k]];
    if (garment.triangles_at_rest[t].has_surface() &&
        *std::max_element(corners.begin(), corners.end()) >= rows.pin_count) {
      movable.push_back({corners, t});
    }
  }
  const auto sorted = [](Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::stable_sort(movable.begin(), movable.end(), [&](const TriangleInRows& a, const TriangleInRows& b) {
    return sorted(a.corners) < sorted(b.corners);
  });
  return movable;
}

/// Sums over the corners of products of gradients: the matrix that the sum of w (g v)^2 is made with.
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

/// Inverse weights of corners in the projection, in parts of the inverse masses; see projection_ratio.
std::array<double, 3> weighted(const std::array<double, 3>& inverse_masses, const Corners& corners, const Rows& rows) {
  std::array<double, 3> inverse_weights = inverse_masses;
  const Index nearest = *std::min_element(corners.begin(), corners.end());
  for (std::size_t k = 0; k < 3; ++k) inverse_weights[k] /= projection_ratio(nearest, corners[k], rows);
  return inverse_weights;
}

class SurfaceMaker {
 public:
  SurfaceMaker(const Garment& garment, const Pins& pins, const Rows& rows)
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
      inverse_masses[corner] = pins_.inverse_masses_per_kg[rows_.vertex_of_row[t.corners[corner]]];
    }
    block.along_per_m[k] = static_cast<float>(rest.along_per_m);
    block.across_per_m[k] = static_cast<float>(rest.across_per_m);
    block.skew_per_m[k] = static_cast<float>(rest.skew_per_m);
    const SquaredGradients sums = squared_gradients(rest, inverse_masses);
    lanes_.has_thin = lanes_.has_thin || is_thin(rest);
    set_mobility(sums, inverse_masses, k, block.mobility);
    const std::array<double, 3> weights = weighted(inverse_masses, t.corners, rows_);
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
  const Rows& rows_;
  SurfaceLanes lanes_;
};

}  // namespace

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

SurfaceLanes make_surface_lanes(const Garment& garment, const Pins& pins, const Rows& rows) {
  const std::vector<TriangleInRows> triangles = movable_triangles(garment, rows);
  std::vector<Corners> corners;
  for (const TriangleInRows& t : triangles) corners.push_back(t.corners);
  SurfaceMaker maker(garment, pins, rows);
  for (const std::vector<std::size_t>& colour : coloured(corners, rows.vertex_count())) {
    maker.append_colour(triangles, colour);
  }
  SurfaceLanes lanes = maker.take();
  // In fine cloth triangles are longest where folds end, anywhere: less is swept again, and all is corrected more.
  const bool is_fine = triangles.size() >= tuning::fine_triangles;
  if (is_fine) lanes.relaxation = tuning::fine_relaxation;
  const double first_part = is_fine ? tuning::swept_again * tuning::swept_again : tuning::swept_again;
  if (rows.pin_count > 0) sweep_again_near_pins(first_part, lanes);
  return lanes;
}

}  // namespace taut::sim::bounded
