#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "sim/contact/layers.hpp"
#include "sim/contact/neighbour_list.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

/// Points scattered in a cube of this size, negative coordinates included.
std::vector<Vec3> scattered(std::size_t count, double size_m) {
  std::vector<Vec3> points;
  std::uint64_t random = 42;
  const auto next = [&] {
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(random >> 33) / 2147483648.0 - 0.5;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const double x = next(), y = next(), z = next();
    points.push_back(Vec3(x, y, z) * size_m);
  }
  return points;
}

std::set<Edge> closer_than(const std::vector<Vec3>& points, double distance_m) {
  std::set<Edge> pairs;
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      if (glm::length(points[a] - points[b]) < distance_m) {
        pairs.insert({a, b});
      }
    }
  }
  return pairs;
}

std::set<Edge> listed(const NeighbourList& list) {
  return {list.pairs().begin(), list.pairs().end()};
}

TEST(NeighbourList, EqualsASearchThroughAllPairs) {
  const std::vector<Vec3> points = scattered(600, 1.0);
  const std::vector<Vec3> far_apart = scattered(600, 1000.0);
  NeighbourList list;
  list.update(far_apart, points, 0.05);
  EXPECT_EQ(listed(list), closer_than(points, 1.35 * 0.05)) << "thickness and skin";
  EXPECT_EQ(listed(list).size(), list.pairs().size()) << "no pair twice";
  EXPECT_GT(list.pairs().size(), 150u);
}

TEST(NeighbourList, StaysCompleteWhileVerticesMove) {
  std::vector<Vec3> points = scattered(400, 1.0);
  const std::vector<Vec3> far_apart = scattered(400, 1000.0);
  const std::vector<Vec3> velocities = scattered(400, 0.05);
  NeighbourList list;
  for (int step = 0; step < 30; ++step) {
    list.update(far_apart, points, 0.05);
    const std::set<Edge> known = listed(list);
    for (const Edge& pair : closer_than(points, 0.05)) {
      EXPECT_TRUE(known.count(pair)) << "step " << step;
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
      points[v] += velocities[v];
    }
  }
}

TEST(NeighbourList, LeavesOutNeighboursInTheClothItself) {
  const Mesh cloth = make_grid({});
  NeighbourList list;
  list.update(cloth.positions, cloth.positions, 0.125);
  for (const Edge& pair : list.pairs()) {
    EXPECT_GT(glm::length(cloth.positions[pair[0]] - cloth.positions[pair[1]]), 0.25);
  }
}

TEST(Layers, PartingMovesOnlyPairsThatAreTooCloseAndKeepsTheirMomentum) {
  std::vector<Vec3> p = {{0, 0, 0}, {0, 0.004, 0}, {1, 0, 0}, {1, 0.02, 0}};
  const std::vector<double> inverse_masses = {1.0, 3.0, 1.0, 1.0};
  part_layers(std::vector<Edge>{{0, 1}, {2, 3}}, 0.012, inverse_masses, p);
  EXPECT_NEAR(p[1].y - p[0].y, 0.012, 1e-15);
  EXPECT_NEAR(p[0].y, -0.002, 1e-15);
  EXPECT_EQ(p[3], Vec3(1, 0.02, 0));
}

TEST(Layers, PartingInPartRemovesTheApproachAndGivesNoSpeed) {
  const LayerParting a_little = {0.01, 0.25, false};
  const Vec3 between(0.0, 0.006, 0.0);
  const Vec3 approaching(0.002, -0.003, 0.0);
  const double w_i = 1.0;
  const double w_j = 3.0;
  const Parted parted = part(a_little, between, approaching, w_i + w_j).value();
  EXPECT_NEAR((w_i + w_j) * parted.current.y, 0.25 * 0.004, 1e-15);
  const Vec3 moved_then = approaching + (w_i + w_j) * (parted.current - parted.previous);
  EXPECT_NEAR(moved_then.y, 0.0, 1e-15);
  EXPECT_NEAR(moved_then.x, 0.002, 1e-15) << "what slides goes on sliding";
  EXPECT_EQ(part(a_little, between, -approaching, 4.0)->previous, parted.current) << "nothing is drawn back";
  EXPECT_FALSE(part(a_little, {0.01, 0.0, 0.0}, approaching, 4.0)) << "far enough";
  EXPECT_FALSE(part(a_little, Vec3(0.0), approaching, 4.0)) << "no direction";
  EXPECT_FALSE(part(a_little, between, approaching, 0.0)) << "both pinned";
}

/// Two loose 17x17 sheets of 0.5 m, one 0.2 m above the other, which lies on the floor, turned a little.
Simulation falling_sheet(double layer_distance_m) {
  GridSettings settings;
  settings.columns = settings.rows = 17;
  settings.width_m = settings.height_m = 0.5;
  settings.plane = GridPlane::horizontal;
  settings.top_centre_m = {0, 0.01, -0.25};
  Mesh sheets = make_grid(settings);
  const auto lower = static_cast<Index>(sheets.positions.size());
  settings.top_centre_m = {0.011, 0.2, -0.247};
  const Mesh upper = make_grid(settings);
  sheets.positions.insert(sheets.positions.end(), upper.positions.begin(), upper.positions.end());
  for (Triangle t : upper.triangles) {
    sheets.triangles.push_back({t[0] + lower, t[1] + lower, t[2] + lower});
  }
  sheets.quads.clear();
  Surroundings surroundings;
  surroundings.bodies = {{.shape = Plane{}, .friction = 0.5}};
  surroundings.layer_distance_m = layer_distance_m;
  return {share(make_garment(sheets)), {}, {}, surroundings};
}

/// The mean height of the upper sheet above the lower one after it has fallen.
double gap_m(Simulation simulation) {
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  const std::vector<Vec3>& p = simulation.state().current;
  const std::size_t half = p.size() / 2;
  double gap = 0.0;
  for (std::size_t v = 0; v < half; ++v) {
    gap += (p[half + v].y - p[v].y) / static_cast<double>(half);
  }
  return gap;
}

TEST(Layers, LieOnEachOtherIfADistanceIsKept) {
  EXPECT_NEAR(gap_m(falling_sheet(0.0)), 0.0, 1e-3) << "without it both end on the floor";
  EXPECT_GT(gap_m(falling_sheet(0.03)), 0.01);
}

}  // namespace
}  // namespace taut::sim
