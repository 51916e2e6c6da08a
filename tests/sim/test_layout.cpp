// The order in which the bounded solver works.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "sheets.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

TEST(Layout, EveryMovableSpringIsInOneLaneAndColoursShareNoVertex) {
  const Garment garment = make_garment(irregular_sheet(12, 1.0));
  const Pins pins = make_pins(garment, {0, 1, 11});
  const Layout layout = make_layout(garment, pins);
  const SpringLanes& lanes = layout.springs;
  std::vector<int> seen(garment.springs.size(), 0);
  for (const auto [begin, end, again] : lanes.sweep) {
    std::vector<int> used(layout.row_count(), 0);
    for (std::size_t k = begin * block_size; k < end * block_size; ++k) {
      EXPECT_EQ(used[lanes.row_i(k)]++, 0);
      EXPECT_EQ(used[lanes.row_j(k)]++, 0);
      if (lanes.spring[k] != SpringLanes::no_spring) {
        ++seen[lanes.spring[k]];
        const auto [a, b] = garment.springs.ends[lanes.spring[k]];
        EXPECT_EQ(std::minmax(layout.vertex_indices[lanes.row_i(k)], layout.vertex_indices[lanes.row_j(k)]),
                  std::minmax(a, b));
      } else {
        EXPECT_GE(lanes.row_i(k), layout.vertex_count());
      }
    }
  }
  for (std::size_t s = 0; s < garment.springs.begin_index(SpringKind::flexural); ++s) {
    const auto [a, b] = garment.springs.ends[s];
    const bool between_pins = pins.inverse_masses_per_kg[a] + pins.inverse_masses_per_kg[b] == 0.0;
    EXPECT_EQ(seen[s], between_pins ? 0 : 1);
  }
}

TEST(Layout, RowsAreInTheOrderOfTheirDistanceFromThePins) {
  const Garment garment = make_garment(sheet(5, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {2}));
  EXPECT_EQ(layout.vertex_indices[0], 2u);
  EXPECT_TRUE(std::is_sorted(layout.distance_from_pins_m.begin(), layout.distance_from_pins_m.end()));
  EXPECT_NEAR(layout.distance_from_pins_m.back(), std::hypot(0.5, 1.0), 1e-12);
}

TEST(Layout, TheStartOfAFrameIsKeptToTheDigitsOfTwoSinglePrecisionNumbers) {
  const Garment garment = make_garment(sheet(9, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {0}));
  std::vector<Vec3> positions_m = garment.mesh.positions;
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    positions_m[v] += 1.0 / (static_cast<double>(v) + 3.0);
  }
  StartRows start;
  set_start(layout, positions_m, start);
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 from_origin_m = positions_m[layout.vertex_indices[row]] - positions_m[layout.vertex_indices[0]];
    EXPECT_LT(glm::distance(to_vec3(start.high[row]) + to_vec3(start.low[row]), from_origin_m), 1e-14) << row;
  }
}

/// Returns the garment's triangles by the sorted solver indices of their corners.
std::map<std::array<Index, 3>, Index> triangles_by_rows(const Garment& garment, const Layout& layout) {
  std::map<std::array<Index, 3>, Index> triangles;
  for (Index t = 0; t < garment.mesh.triangles.size(); ++t) {
    std::array<Index, 3> rows;
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k] = layout.solver_indices[garment.mesh.triangles[t][k]];
    }
    std::sort(rows.begin(), rows.end());
    triangles[rows] = t;
  }
  return triangles;
}

TEST(Layout, EveryMovableTriangleIsInOneLaneAndColoursShareNoVertex) {
  const Garment garment = make_garment(irregular_sheet(12, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {0, 1, 12, 13}), BoundKind::surface);
  const SurfaceLanes& lanes = layout.surface;
  const auto triangles = triangles_by_rows(garment, layout);
  std::vector<int> seen(garment.mesh.triangles.size(), 0);
  for (const auto [begin, end, again] : lanes.sweep) {
    std::vector<int> used(layout.row_count(), 0);
    for (std::size_t lane = begin * block_size; lane < end * block_size; ++lane) {
      std::array<Index, 3> rows;
      for (std::size_t k = 0; k < 3; ++k) {
        rows[k] = lanes.blocks[lane / block_size].at[k][lane % block_size] / 4;
        EXPECT_TRUE(rows[k] >= layout.vertex_count() || used[rows[k]]++ == 0);
      }
      std::sort(rows.begin(), rows.end());
      EXPECT_EQ(lanes.mobility_per_kg[lane] > 0.0F, rows[0] < layout.vertex_count());
      if (rows[0] < layout.vertex_count() && !again) {
        ++seen[triangles.at(rows)];
      }
    }
  }
  for (std::size_t t = 0; t < seen.size(); ++t) {
    const Triangle& corners = garment.mesh.triangles[t];
    const bool is_pinned = std::all_of(corners.begin(), corners.end(),
                                       [&](Index v) { return layout.solver_indices[v] < layout.pin_count; });
    EXPECT_EQ(seen[t], is_pinned ? 0 : 1) << t;
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 2) << "between the pins";
  EXPECT_TRUE(layout.springs.blocks.empty()) << "triangles hold all their edges";
}

TEST(Layout, OnlyTrianglesNearThePinsAreSweptAgain) {
  const Garment garment = make_garment(irregular_sheet(33, 1.0));
  const Layout layout = make_layout(garment, make_pins(garment, {0}), BoundKind::surface);
  double max_distance_m = 0.0;
  for (const auto [begin, end, again] : layout.surface.sweep) {
    for (std::size_t lane = begin * block_size; again && lane < end * block_size; ++lane) {
      const auto& at = layout.surface.blocks[lane / block_size].at;
      const std::size_t k = lane % block_size;
      const Index row = std::min({at[0][k], at[1][k], at[2][k]}) / 4;
      max_distance_m =
          row < layout.vertex_count() ? std::max(max_distance_m, layout.distance_from_pins_m[row]) : max_distance_m;
    }
  }
  EXPECT_GT(max_distance_m, 0.2);
  EXPECT_LT(max_distance_m, 1.0) << "of 1.4";
  const Layout unpinned = make_layout(garment, make_pins(garment, {}), BoundKind::surface);
  EXPECT_TRUE(std::none_of(unpinned.surface.sweep.begin(), unpinned.surface.sweep.end(),
                           [](const BlockRange& range) { return range.is_repeat; }));
}

TEST(Layout, FineClothIsSweptLessAgainAndCorrectedMore) {
  const auto laid_out = [](Index count) {
    const Garment garment = make_garment(irregular_sheet(count, 1.0));
    return make_layout(garment, make_pins(garment, {0}), BoundKind::surface).surface;
  };
  const auto part_again = [](const SurfaceLanes& lanes) {
    double blocks = 0.0;
    for (const auto [begin, end, again] : lanes.sweep) blocks += again ? end - begin : 0.0;
    return blocks / static_cast<double>(lanes.block_count());
  };
  const SurfaceLanes coarse = laid_out(100);
  const SurfaceLanes fine = laid_out(102);
  EXPECT_EQ(coarse.relaxation, 1.0F);
  EXPECT_GT(fine.relaxation, 1.2F);
  EXPECT_LT(fine.relaxation, 4.0F / 3.0F) << "where time steps of a sweep each are stable";
  EXPECT_NEAR(part_again(coarse), 0.35 + 0.12 + 0.04, 0.02);
  EXPECT_NEAR(part_again(fine), 0.12 + 0.04, 0.02);
}

TEST(Layout, NeedlesAndBentCellsAreHeldByTheirSprings) {
  Mesh mesh = sheet(3, 1.0);
  const auto free_springs = [](const Mesh& cloth) {
    const Garment garment = make_garment(cloth);
    const std::vector<bool> held = springs_held_by_triangles(garment);
    const auto bound = held.begin() + static_cast<std::ptrdiff_t>(garment.springs.begin_index(SpringKind::flexural));
    return std::count(held.begin(), bound, false);
  };
  EXPECT_EQ(free_springs(mesh), 0);
  mesh.positions[0].z += 0.1;
  EXPECT_EQ(free_springs(mesh), 1) << "the diagonal that no triangle has";
  // A vertex almost on the edge of its triangle: both of its short edges belong to the needle alone.
  const Mesh needle = {{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-5, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}, {}};
  EXPECT_EQ(free_springs(needle), 2);
}

}  // namespace
}  // namespace taut::sim
