#include "tailor/sewing/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tailor/flat/triangulate.hpp"

namespace taut::tailor {
namespace {

// Part of the edge length: nearly as dense as random points can be.
constexpr double first_spacing = 0.85;
// Factor on the spacing after misses_before_decay points in a row that did not fit.
constexpr double spacing_decay = 0.98;
constexpr int misses_before_decay = 2000;
// Part of the edge length. A point closer to the outline could lie in the circle over an outline edge; then that
// edge would not be a Delaunay edge.
constexpr double outline_clearance = 0.6;
// More rounds give a more regular mesh; many would approach a hexagonal grid.
constexpr int smoothing_rounds = 12;

/// Points by square cells, for finding whether any lies within a cell's width.
class PointGrid {
 public:
  PointGrid(const Vec2& low, const Vec2& high, double cell_m)
      : low_(low),
        cell_m_(cell_m),
        columns_(cell(high.x - low.x) + 1),
        rows_(cell(high.y - low.y) + 1),
        cells_(columns_ * rows_) {}

  void add(const Vec2& p) { cells_[row(p) * columns_ + column(p)].push_back(p); }

  bool has_within(const Vec2& p, double distance_m) const {
    const std::size_t last_row = std::min(row(p) + 1, rows_ - 1);
    const std::size_t last_column = std::min(column(p) + 1, columns_ - 1);
    for (std::size_t r = row(p) == 0 ? 0 : row(p) - 1; r <= last_row; ++r) {
      for (std::size_t c = column(p) == 0 ? 0 : column(p) - 1; c <= last_column; ++c) {
        const auto& there = cells_[r * columns_ + c];
        if (std::any_of(there.begin(), there.end(),
                        [&](const Vec2& q) { return glm::length(q - p) < distance_m; })) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  std::size_t cell(double offset_m) const { return static_cast<std::size_t>(offset_m / cell_m_); }
  std::size_t column(const Vec2& p) const { return cell(p.x - low_.x); }
  std::size_t row(const Vec2& p) const { return cell(p.y - low_.y); }

  Vec2 low_;
  double cell_m_;
  std::size_t columns_, rows_;
  std::vector<std::vector<Vec2>> cells_;
};

/// Throws darts that keep their distance from each other and from the outline, and lowers the distance when
/// nothing fits any more, until there are enough.
void throw_darts(Panel& panel, std::size_t count, double edge_length_m, Random& random) {
  const std::vector<Vec2> outline = panel.flat_m;
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  PointGrid grid(low, high, edge_length_m);
  for (const Vec2& p : outline) {
    grid.add(p);
  }
  double spacing_m = first_spacing * edge_length_m;
  int misses = 0;
  while (panel.flat_m.size() < outline.size() + count) {
    // Two statements: the order in which arguments are evaluated is the compiler's choice.
    const double x = random.between(low.x, high.x);
    const double y = random.between(low.y, high.y);
    if (is_inside(outline, {x, y}) && !grid.has_within({x, y}, spacing_m)) {
      grid.add({x, y});
      panel.flat_m.emplace_back(x, y);
      misses = 0;
    } else if (++misses == misses_before_decay) {
      spacing_m *= spacing_decay;
      misses = 0;
    }
  }
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - (a + along * (b - a)));
}

bool is_clear_of_outline(const Panel& panel, const Vec2& p, double clearance_m) {
  const std::size_t n = panel.outline_count;
  for (std::size_t i = 0; i < n; ++i) {
    if (distance_to_segment(p, panel.flat_m[i], panel.flat_m[(i + 1) % n]) < clearance_m) {
      return false;
    }
  }
  return is_inside(std::span(panel.flat_m).first(n), p);
}

/// Moves every interior point to the mean of its neighbours, unless that takes it too near the outline.
void smooth(Panel& panel, double clearance_m) {
  std::vector<Vec2> sum(panel.flat_m.size(), Vec2(0.0));
  std::vector<int> neighbours(panel.flat_m.size(), 0);
  for (const Triangle& t : panel.triangles) {
    // Around an interior point every neighbour is met twice, once from each side.
    for (std::size_t k = 0; k < 3; ++k) {
      sum[t[k]] += panel.flat_m[t[(k + 1) % 3]] + panel.flat_m[t[(k + 2) % 3]];
      neighbours[t[k]] += 2;
    }
  }
  for (std::size_t p = panel.outline_count; p < panel.flat_m.size(); ++p) {
    const Vec2 target = sum[p] / static_cast<double>(neighbours[p]);
    if (is_clear_of_outline(panel, target, clearance_m)) {
      panel.flat_m[p] = target;
    }
  }
}

}  // namespace

void fill_panel(Panel& panel, std::size_t count, double edge_length_m, Random& random) {
  throw_darts(panel, count, edge_length_m, random);
  panel.triangles = triangulate(panel.flat_m, panel.outline_count);
  for (int round = 0; round < smoothing_rounds; ++round) {
    smooth(panel, outline_clearance * edge_length_m);
    panel.triangles = triangulate(panel.flat_m, panel.outline_count);
  }
}

}  // namespace taut::tailor
