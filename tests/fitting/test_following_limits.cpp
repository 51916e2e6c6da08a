// Limits on the shape of a model that follows a simulation mesh.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "app/garments/fitting/tuning.hpp"
#include "app/models/mending/following_limits.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

constexpr int columns = 12;
constexpr double max_stretch = 0.02;

/// Adds a level square of 1 m at this height.
void add_square(double height_m, sim::Mesh& mesh) {
  const auto first = static_cast<sim::Index>(mesh.positions.size());
  for (int z = 0; z <= columns; ++z) {
    for (int x = 0; x <= columns; ++x) mesh.positions.emplace_back(double(x) / columns, height_m, double(z) / columns);
  }
  const auto at = [&](int x, int z) { return first + static_cast<sim::Index>(z * (columns + 1) + x); };
  for (int z = 0; z < columns; ++z) {
    for (int x = 0; x < columns; ++x) {
      mesh.triangles.push_back({at(x, z), at(x, z + 1), at(x + 1, z)});
      mesh.triangles.push_back({at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)});
    }
  }
}

sim::Mesh squares(std::initializer_list<double> heights_m) {
  sim::Mesh mesh;
  for (const double height_m : heights_m) add_square(height_m, mesh);
  return mesh;
}

TEST(ShapeLimits, KeepTheirBoundFromAnyShape) {
  const sim::Mesh model = squares({0.0});
  const ShapeLimits limits(model, max_stretch, {});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise_m(-0.02, 0.02);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec3> points_m = model.positions;
    for (Vec3& p : points_m) p += Vec3(noise_m(random), noise_m(random), noise_m(random));
    EXPECT_GT(limits.measure(points_m).surface_p99, 0.1);
    const Vec3 before_m = std::accumulate(points_m.begin(), points_m.end(), Vec3(0.0));
    limits.apply(points_m, points_m);
    const FollowingMeasures after = limits.measure(points_m);
    EXPECT_LE(after.stretch.max, max_stretch + 0.005);
    EXPECT_LE(after.surface_p99, max_stretch + 0.005);
    EXPECT_LT(glm::distance(std::accumulate(points_m.begin(), points_m.end(), Vec3(0.0)), before_m), 0.05)
        << "the middle moved by a thousandth of this";
  }
}

TEST(ShapeLimits, LeaveAShapeWithinThemAsItIs) {
  const sim::Mesh model = squares({0.0, 0.05});
  std::vector<Vec3> points_m = model.positions;
  for (Vec3& p : points_m) p = {0.95 * p.x, p.y + 0.01 * p.x, p.z};
  const std::vector<Vec3> before_m = points_m;
  ShapeLimits(model, max_stretch, {}).apply(before_m, points_m);
  EXPECT_EQ(points_m, before_m);
}

TEST(ShapeLimits, TakeLayersApartThatDoNotCrossAsModelled) {
  const sim::Mesh model = squares({0.0, 0.004});
  const ShapeLimits limits(model, max_stretch, {});
  std::vector<Vec3> points_m = model.positions;
  points_m[6 * (columns + 1) + 6].y = 0.006;
  EXPECT_GT(limits.measure(points_m).new_crossings, 0u);
  limits.apply(model.positions, points_m);
  EXPECT_EQ(limits.measure(points_m).crossings, 0u);
}

// A place of the lower layer, 5 cm below, has come 1 mm through the upper one.
TEST(ShapeLimits, MoveLayersByNoMoreThanTheDepthOfTheirCrossing) {
  const sim::Mesh model = squares({0.0, 0.05});
  const ShapeLimits limits(model, 0.5, {});
  std::vector<Vec3> points_m = model.positions;
  points_m[6 * (columns + 1) + 6].y = 0.051;
  EXPECT_GT(limits.measure(points_m).new_crossings, 0u);
  limits.apply(points_m, points_m);
  EXPECT_EQ(limits.measure(points_m).crossings, 0u);
  for (std::size_t v = points_m.size() / 2; v < points_m.size(); ++v) EXPECT_NEAR(points_m[v].y, 0.05, 0.01);
}

// A button of 2 cm that stands on the cloth at a slant has sunk into it. Only the cloth may give way.
TEST(ShapeLimits, TakeClothAwayFromAButtonThatStaysRigid) {
  sim::Mesh model = squares({0.0});
  const auto first = static_cast<sim::Index>(model.positions.size());
  for (const auto& [x_m, z_m] : {std::pair(0.0, 0.0), {0.02, 0.0}, {0.02, 0.02}, {0.0, 0.02}}) {
    model.positions.emplace_back(0.52 + x_m, 0.002 + 0.4 * x_m, 0.52 + z_m);
  }
  model.triangles.push_back({first, first + 3, first + 1});
  model.triangles.push_back({first + 1, first + 3, first + 2});
  std::vector<sim::Index> rigid_parts(first, sim::no_vertex);
  rigid_parts.resize(model.positions.size(), first);
  const ShapeLimits limits(model, max_stretch, rigid_parts);
  std::vector<Vec3> points_m = model.positions;
  for (sim::Index v = first; v < points_m.size(); ++v) points_m[v].y -= 0.005;
  const std::vector<Vec3> before_m = points_m;
  EXPECT_GT(limits.measure(points_m).new_crossings, 0u);
  limits.apply(points_m, points_m);
  EXPECT_EQ(limits.measure(points_m).new_crossings, 0u);
  for (sim::Index v = first; v < points_m.size(); ++v) EXPECT_EQ(points_m[v], before_m[v]);
}

TEST(ShapeLimits, LeaveCrossingsThatAreModelled) {
  sim::Mesh model = squares({0.0, 0.004});
  model.positions[6 * (columns + 1) + 6].y = 0.006;
  const ShapeLimits limits(model, max_stretch, {});
  std::vector<Vec3> points_m = model.positions;
  const FollowingMeasures before = limits.measure(points_m);
  EXPECT_GT(before.crossings, 0u);
  EXPECT_EQ(before.new_crossings, 0u);
  limits.apply(model.positions, points_m);
  EXPECT_EQ(points_m, model.positions);
}

TEST(Following, AButtonStaysRigidAndAPatchBends) {
  for (const double size_m : {0.01, 0.2}) {
    const sim::Mesh sheet = squares({0.0});
    sim::Mesh model = sheet;
    std::vector<std::uint8_t> is_wall(model.triangles.size(), 1);
    const auto first = static_cast<sim::Index>(model.positions.size());
    for (const Vec3& p : squares({0.002}).positions)
      model.positions.push_back(Vec3(0.45, 0.0, 0.45) + Vec3(size_m * p.x, p.y, size_m * p.z));
    for (const sim::Triangle& t : sheet.triangles)
      model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    is_wall.resize(model.triangles.size(), 0);
    const std::vector<Bond> bonds = bonds_of_model(model, is_wall, sheet);
    std::vector<Vec3> moved_m = sheet.positions;
    for (Vec3& p : moved_m) p.y += 0.1 * std::sin(30.0 * p.x);
    std::vector<Vec3> points_m = follow(bonds, moved_m, sheet.triangles, fitting::normal_smoothing_rounds);
    ShapeLimits(model, 0.5, find_rigid_parts(model, is_wall)).apply(points_m, points_m);
    double max_change = 0.0;
    for (sim::Index v = first; v < points_m.size(); ++v) {
      const double was_m = glm::distance(model.positions[first], model.positions[v]);
      max_change = std::max(max_change, std::abs(glm::distance(points_m[first], points_m[v]) - was_m));
    }
    EXPECT_EQ(max_change < 1e-9, size_m < 0.03) << "of " << size_m << " m it changed by " << max_change;
  }
}

// The lower of two walls lies above the upper one: smoothing keeps it there.
TEST(ShapeLimits, BringWallsBackToTheirSidesAsModelled) {
  const sim::Mesh model = squares({0.0, 0.004});
  const ShapeLimits limits(model, max_stretch, {});
  std::vector<Vec3> points_m = model.positions;
  const std::size_t count = points_m.size() / 2;
  for (std::size_t v = 0; v < count; ++v) {
    const double x = points_m[v].x - 0.5, z = points_m[v].z - 0.5;
    points_m[v].y += 0.012 * std::exp(-40.0 * (x * x + z * z));
  }
  EXPECT_GT(limits.measure(points_m).new_crossings, 50u);
  limits.apply(points_m, points_m);
  EXPECT_EQ(limits.measure(points_m).crossings, 0u);
  for (std::size_t v = 0; v < count; ++v) EXPECT_LT(points_m[v].y, points_m[v + count].y);
}

// Layers that are far from each other as modelled cross where they meet. The simulation mesh tells which is above.
TEST(ShapeLimits, OtherLayersLieAsTheSimulationMeshDoes) {
  const sim::Mesh model = squares({0.0, 0.5});
  const ShapeLimits limits(model, max_stretch, {});
  const std::size_t count = model.positions.size() / 2;
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec3> points_m = model.positions, feet_m = model.positions;
    for (std::size_t v = 0; v < count; ++v) {
      feet_m[v].y = 0.0;
      feet_m[v + count].y = 0.001 * side;
      points_m[v + count].y = 0.003 * (points_m[v].x - 0.5);
    }
    EXPECT_GT(limits.measure(points_m).new_crossings, 10u);
    limits.apply(feet_m, points_m);
    EXPECT_EQ(limits.measure(points_m).crossings, 0u);
    for (std::size_t v = 0; v < count; ++v) EXPECT_GT(side * (points_m[v + count].y - points_m[v].y), 0.0);
  }
}

}  // namespace
}  // namespace taut::app
