#include <gtest/gtest.h>

#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float thickness_m = 1e-3F;

/// A triangle of cloth and a vertex of a body, which rises from below.
struct Scene {
  Scene(float distance_m, float moves_m) {
    rows.positions = {{0.0F, 0.0F, 0.0F, 0.0F},
                      {0.01F, 0.0F, 0.0F, 0.0F},
                      {0.0F, 0.0F, 0.01F, 0.0F},
                      {0.003F, -distance_m, 0.003F, 0.0F}};
    rows.moves = {{}, {}, {}, {0.0F, moves_m, 0.0F, 0.0F}};
    rows.radii = {1e-3F, 1e-3F, 1e-3F, 0.0F};
    rows.inverse_masses_per_kg = {1e4F, 1e4F, 1e4F, 0.0F};
    rows.cloth_count = 3;
  }

  RowMoves rows;
  std::vector<ContactPair> pairs = {{{{3, 0, 1, 2}, 1}, thickness_m, 0.3F}};
};

TEST(Regions, ClothThatTouchesAsNearAsItMayGivesWay) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  for (const float distance_m : {1e-4F, 0.9e-4F, 0.5e-4F, 1.5e-4F}) {
    for (const float moves_m : {1e-6F, 5e-6F, 2e-5F, 3e-4F}) {
      Scene scene(distance_m, moves_m);
      Regions regions;
      ASSERT_TRUE(regions.make(scene.pairs, scene.rows, kernels));
      EXPECT_FALSE(regions.blocked()) << distance_m << " " << moves_m;
      EXPECT_EQ(scene.rows.moves[0].y, 0.0F);
    }
  }
}

TEST(Regions, WhatCannotGiveWayIsNamed) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  Scene scene(1e-4F, 3e-4F);
  scene.rows.inverse_masses_per_kg = {0.0F, 0.0F, 0.0F, 0.0F};
  Regions regions;
  ASSERT_TRUE(regions.make(scene.pairs, scene.rows, kernels));
  ASSERT_TRUE(regions.blocked());
  EXPECT_EQ(regions.blocked()->near, scene.pairs[0].near);
  EXPECT_NEAR(regions.blocked()->distance, 1e-4F, 1e-7F);
}

TEST(Regions, WhatTouchesFromTheStartIsNamed) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  Scene scene(0.0F, 1e-5F);
  Regions regions;
  ASSERT_TRUE(regions.make(scene.pairs, scene.rows, kernels));
  ASSERT_TRUE(regions.blocked());
  EXPECT_EQ(regions.blocked()->near, scene.pairs[0].near);
}

/// Layers above each other, and a vertex of a body that rises from below. The order of the pairs is the worst one for a
/// pass to hand a push on.
Scene pushed_pile(Index layers, float moves_m) {
  constexpr float apart_m = 1.2e-4F;
  Scene scene(apart_m, moves_m);
  for (Index layer = 1; layer < layers; ++layer) {
    const Index below = layer == 1 ? 0 : 3 * layer - 2;
    const auto first = static_cast<Index>(scene.rows.positions.size());
    for (Index k = 0; k < 3; ++k) {
      Float4 above = scene.rows.positions[k];
      above.y = apart_m * static_cast<float>(layer);
      scene.rows.positions.push_back(above);
      scene.rows.moves.push_back({});
      scene.rows.radii.push_back(1e-3F);
      scene.rows.inverse_masses_per_kg.push_back(1e4F);
      scene.pairs.insert(scene.pairs.begin(), {{{below + k, first, first + 1, first + 2}, 1}, thickness_m, 0.3F});
    }
  }
  scene.rows.cloth_count = scene.rows.positions.size();
  return scene;
}

// Twelve passes over the pairs would leave eight layers in place, and the rising vertex would run into them.
TEST(Regions, APushGoesThroughAPile) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  Scene scene = pushed_pile(20, 3e-4F);
  Regions regions;
  ASSERT_TRUE(regions.make(scene.pairs, scene.rows, kernels));
  EXPECT_FALSE(regions.blocked());
}

// A heavy layer would still stop the rising vertex after 144 passes that demand the thickness, weighted by masses.
TEST(Regions, AHeavyLayerGivesWayToAPileThatIsPushed) {
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  Scene scene = pushed_pile(6, 3e-4F);
  for (std::size_t row = scene.rows.cloth_count - 3; row < scene.rows.cloth_count; ++row) {
    scene.rows.inverse_masses_per_kg[row] = 100.0F;
  }
  Regions regions;
  ASSERT_TRUE(regions.make(scene.pairs, scene.rows, kernels));
  EXPECT_FALSE(regions.blocked());
}

}  // namespace
}  // namespace taut::sim::bounded
