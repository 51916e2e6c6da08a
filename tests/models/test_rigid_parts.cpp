// Parts of models that are no cloth.

#include <gtest/gtest.h>

#include <numbers>

#include "app/garments/dressing/wearing.hpp"
#include "garment_shapes.hpp"
#include "loading_shapes.hpp"

namespace taut::app {
namespace {

sim::Mesh ball(const sim::Vec3& at_m, double radius_m) {
  constexpr sim::Index rings = 12, around = 16;
  sim::Mesh mesh;
  for (sim::Index k = 0; k <= rings * around + around; ++k) {
    const double polar = std::numbers::pi * (k / around) / rings;
    const double angle = 2.0 * std::numbers::pi * (k % around) / around;
    mesh.positions.push_back(at_m + radius_m * sim::Vec3(std::sin(polar) * std::sin(angle), std::cos(polar),
                                                         std::sin(polar) * std::cos(angle)));
  }
  for (sim::Index k = 0; k < rings * around; ++k) {
    const sim::Index next = k % around + 1 < around ? k + 1 : k + 1 - around;
    mesh.triangles.push_back({k, k + around, next});
    mesh.triangles.push_back({next, k + around, next + around});
  }
  return mesh;
}

sim::Mesh stretched(sim::Mesh mesh, const sim::Vec3& by) {
  for (sim::Vec3& p : mesh.positions) p *= by;
  return mesh;
}

/// A long skirt, and a stand within it that is closed at its top and open below.
const sim::Mesh long_skirt = stretched(test::skirt(), {1.0, 3.0, 1.0});
const sim::Mesh open_stand = [] {
  sim::Mesh mesh = stretched(long_skirt, {0.9, 1.0, 0.9});
  const auto count = static_cast<sim::Index>(mesh.positions.size());
  mesh.positions.push_back({0.0, mesh.positions.back().y, 0.0});
  for (sim::Index k = count - 24; k < count; ++k) {
    mesh.triangles.push_back({k, k + 1 < count ? k + 1 : count - 24, count});
  }
  return mesh;
}();

struct Rigid : testing::Test {
  std::size_t count(const sim::Mesh& garment, const sim::Mesh& more) const {
    return test::load(folder, test::both(garment, more)).rigid.count;
  }
  std::vector<sim::Body> bodies(const sim::Mesh& more) {
    loaded = test::load(folder, test::both(test::shirt(), more));
    Scene scene;
    LoadedBodies all;
    put_where_it_begins(loaded, scene, all);
    return all.all;
  }

  test::TemporaryFolder folder;
  LoadedGarment loaded;
};

TEST_F(Rigid, PartsAreABodyThatClothCannotEnter) {
  const std::vector<sim::Body> all = bodies(ball({0.0, 0.4, 0.0}, 0.045));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].name, "the garment's stand");
  EXPECT_EQ(loaded.garment->mesh.positions, test::load(folder, test::shirt()).garment->mesh.positions);
  EXPECT_EQ(loaded.hanging->parts.size(), 1U);
  EXPECT_CONTAINS(test::remarks(loaded),
                  "1 part with 2.7 % of its area is no cloth, but closed and thick, like a stand or a body, and cloth "
                  "cannot enter");
}

TEST_F(Rigid, PartsThatCrossClothAreLeftOut) {
  EXPECT_TRUE(bodies(ball({0.0, 0.4, 0.05}, 0.045)).empty());
  EXPECT_CONTAINS(test::remarks(loaded), "like a stand or a body, and left out");
}

TEST_F(Rigid, PartsAreClosedAndThick) {
  EXPECT_EQ(count(test::shirt(), ball({0.0, 1.2, 0.0}, 0.1)), 1U) << "a head";
  EXPECT_EQ(count(test::shirt(),
                  test::translate(stretched(ball({0.0, 0.0, 0.0}, 0.8), {0.0121, 1.0, 0.0121}), {0.7, 0.0, 0.0})),
            1U)
      << "a pole, with 0.025 of the volume of a ball of the same area";
  EXPECT_EQ(
      count(test::shirt(), test::translate(stretched(ball({0.0, 0.0, 0.0}, 0.2), {1.0, 0.033, 1.0}), {0.0, 1.2, 0.0})),
      0U)
      << "padded cloth, with 0.009";
  EXPECT_EQ(count(test::shirt(), test::translate(test::thick(test::skirt()), {0.0, -0.6, 0.0})), 0U) << "two walls";
  EXPECT_EQ(count(test::shirt(), test::translate(test::thick(test::bottle(0.3, {0.0, 0.0})), {0.0, 1.0, 0.0})), 0U)
      << "a hat with two walls";
  EXPECT_EQ(count(test::shirt(), test::translate(test::bottle(0.3, {0.0, 0.0}), {0.0, 1.0, 0.0})), 0U)
      << "a hat with one";
}

TEST_F(Rigid, PartsWithAnOpenEndLieBelowCloth) {
  EXPECT_EQ(count(long_skirt, open_stand), 1U);
  EXPECT_EQ(count(long_skirt, test::translate(open_stand, {1.0, 0.0, 0.0})), 0U);
}

TEST_F(Rigid, PartsAreNoSmallOnesOnCloth) {
  EXPECT_EQ(count(test::shirt(), ball({0.0, 0.4, 0.07}, 0.01)), 0U) << "a button";
  EXPECT_EQ(count(test::shirt(), ball({0.0, 0.4, 0.09}, 0.01)), 1U);
}

TEST_F(Rigid, PartsAreTheGarmentIfThereIsHardlyAnythingElse) {
  EXPECT_EQ(count(ball({0.0, 0.0, 0.0}, 0.3), ball({0.7, 0.0, 0.0}, 0.3)), 0U);
  EXPECT_EQ(count(ball({0.0, 0.0, 0.0}, 0.3), test::button({0.0, 0.0, 0.31}, 0.1)), 0U);
  EXPECT_EQ(count(ball({0.0, 0.0, 0.0}, 0.3), test::button({0.0, 0.0, 0.31}, 0.3)), 1U);
}

}  // namespace
}  // namespace taut::app
