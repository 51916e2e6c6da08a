#include <gtest/gtest.h>

#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float thickness_m = 1e-3F;

/// A vertex of a body below a triangle of cloth, which comes up.
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

}  // namespace
}  // namespace taut::sim::bounded
