// A fitted mesh beside its model.

#include <gtest/gtest.h>

#include "app/garments/fitting/comparison.hpp"

namespace taut::app {
namespace {

/// Measures of a mesh that is its model.
FittingComparison like() {
  FittingComparison c;
  c.area_fraction = 1.0;
  c.parts = c.model_parts = 2;
  c.triangles = 1000;
  return c;
}

TEST(FittingComparison, SaysWhatDiffers) {
  EXPECT_EQ(why_not_the_model(like()), std::nullopt);
  FittingComparison joined = like();
  joined.parts = 1;
  EXPECT_EQ(why_not_the_model(joined), std::nullopt) << "panels may have been joined";
  const auto says = [](const char* expected, const std::function<void(FittingComparison&)>& change) {
    FittingComparison c = like();
    change(c);
    const std::string found = why_not_the_model(c).value_or("nothing");
    EXPECT_NE(found.find(expected), std::string::npos) << found;
  };
  says("its area is 50 %", [](auto& c) { c.area_fraction = 0.5; });
  says("its area is 120 %", [](auto& c) { c.area_fraction = 1.2; });
  says("20 % of its borders", [](auto& c) { c.torn_fraction = 0.2; });
  says("it has 3 parts", [](auto& c) { c.parts = 3; });
  says("a hundredth of the model is farther", [](auto& c) { c.distance_from_model = 0.1; });
  says("a hundredth of it is farther", [](auto& c) { c.distance_to_model = 0.1; });
  says("it crosses itself in 30 places and the model in 0", [](auto& c) {
    c.crossings = 30;
    c.added_crossing_fraction = 0.03;
  });
  says("it crosses itself in 600 places", [](auto& c) { c.crossings = 600; });
}

/// A square of 1 m.
sim::Mesh square() {
  sim::Mesh mesh;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 10; ++y) mesh.positions.emplace_back(0.1 * x, 0.1 * y, 0.0);
  }
  for (sim::Index x = 0; x < 10; ++x) {
    for (sim::Index y = 0; y < 10; ++y) {
      const sim::Index v = 11 * x + y;
      mesh.triangles.push_back({v, v + 11, v + 1});
      mesh.triangles.push_back({v + 1, v + 11, v + 12});
    }
  }
  return mesh;
}

// The mesh is the front of a plate. Its border runs along the edges of the plate, which has no border.
TEST(FittingComparison, AWallOfAClosedShellIsNotTornAtItsRim) {
  const sim::Mesh front = square();
  sim::Mesh plate = front;
  for (const sim::Vec3& p : front.positions) plate.positions.push_back(p - sim::Vec3(0.0, 0.0, 0.1));
  for (const auto& [a, b, c] : front.triangles) plate.triangles.push_back({a + 121, c + 121, b + 121});
  const std::vector<sim::Index> loop = border_loops(front).at(0);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const sim::Index a = loop[k], b = loop[(k + 1) % loop.size()];
    plate.triangles.push_back({b, a, a + 121});
    plate.triangles.push_back({b, a + 121, b + 121});
  }
  FittedMesh fitted;
  fitted.mesh = front;
  fitted.is_simulated.assign(plate.triangles.size(), 0);
  std::fill_n(fitted.is_simulated.begin(), front.triangles.size(), 1);
  EXPECT_EQ(compare_with_model(plate, 0, fitted).torn_fraction, 0.0);
}

TEST(FittingComparison, MissesWhatWasLost) {
  const sim::Mesh model = square();
  FittedMesh whole;
  whole.mesh = model;
  whole.is_simulated.assign(model.triangles.size(), 1);
  whole.sheets = 1;
  EXPECT_EQ(why_not_the_model(compare_with_model(model, 0, whole)), std::nullopt);
  FittedMesh half = whole;
  half.mesh.triangles.resize(model.triangles.size() / 2);
  const FittingComparison lost = compare_with_model(model, 0, half);
  EXPECT_NEAR(lost.area_fraction, 0.5, 1e-9);
  EXPECT_NEAR(lost.torn_fraction, 1.0 / 3.0, 0.01) << "one of four sides runs where the model has no border";
  EXPECT_GT(lost.distance_from_model, 0.05);
  EXPECT_NEAR(lost.distance_to_model, 0.0, 1e-12);
}

}  // namespace
}  // namespace taut::app
