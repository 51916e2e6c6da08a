#include <gtest/gtest.h>

#include "sim/garment.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"

namespace taut::sim::bounded {
namespace {

// The gap exceeds the deviations of two kinematic primitives from their chords plus the rounding error in single
// precision. The cloth has edges of 0.1 m, extends up to 1.5 m from its first vertex, and moves by centimetres.
TEST(PlaneGap, IsMoreThanAllThatItHasToBeMoreThan) {
  const double thicknesses_m[] = {min_thickness_m, 1.8e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
  for (const double thickness_m : thicknesses_m) {
    const auto t = static_cast<float>(thickness_m);
    const float error_m = distance_error_m({1.5F, 0.1F, 0.03F, 0.2F});
    EXPECT_GT(planned_gap_m(t, error_m), 2.0F * max_off_chord_fraction * t + error_m) << thickness_m;
    EXPECT_EQ(planned_gap_m(t, distance_error_m({1.0F, 0.05F, 0.01F, 0.1F})), min_gap_fraction * t)
        << thickness_m << ": of cloth a metre across the thickness alone decides";
  }
}

TEST(PlaneGap, IsAlwaysTwiceTheError) {
  for (const float from_origin_m : {0.1F, 1.0F, 10.0F, 1e4F}) {
    const float error_m = distance_error_m({from_origin_m, 0.1F, 0.03F, 0.2F});
    EXPECT_GE(error_m, 4.0F * 0x1p-24F * from_origin_m);
    EXPECT_GE(planned_gap_m(1.8e-5F, error_m), 2.0F * error_m);
  }
}

TEST(CollisionDistance, IsLargerForThinnerClothAndAlwaysMoreThanTheThickness) {
  EXPECT_NEAR(collision_distance_m(0.18e-3F), 2.67e-3F, 1e-5F) << "cotton";
  EXPECT_NEAR(collision_distance_m(0.66e-3F), 1.78e-3F, 1e-5F) << "denim";
  EXPECT_EQ(collision_distance_m(1e-3F), collision_distance_per_thickness * 1e-3F) << "jersey";
  for (const float t : {1e-5F, 1e-4F, 3e-4F, 1e-3F, 3e-3F}) {
    EXPECT_GT(collision_distance_m(t), t + tuning::separation_fraction * t * 0.99F);
  }
}

}  // namespace
}  // namespace taut::sim::bounded
