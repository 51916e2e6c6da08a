#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

TEST(Elementary, TheSineOfTurnsAgreesWithTheLibrary) {
  for (int k = -4000; k <= 4000; ++k) {
    const double turns = k / 797.0;
    EXPECT_NEAR(sine_of_turns(turns), std::sin(2.0 * std::numbers::pi * turns), 4e-15) << turns;
  }
  EXPECT_DOUBLE_EQ(sine_of_turns(0.25), 1.0);
  EXPECT_DOUBLE_EQ(sine_of_turns(-0.25), -1.0);
  EXPECT_EQ(sine_of_turns(0.5), 0.0);
  EXPECT_EQ(sine_of_turns(123456.0), 0.0);
}

TEST(Elementary, TheCosineOfTurnsAgreesWithTheLibrary) {
  for (int k = -4000; k <= 4000; ++k) {
    const double turns = k / 797.0;
    EXPECT_NEAR(cosine_of_turns(turns), std::cos(2.0 * std::numbers::pi * turns), 4e-15) << turns;
  }
  EXPECT_EQ(cosine_of_turns(1e9 + 0.25), 0.0);
  EXPECT_DOUBLE_EQ(cosine_of_turns(1e9), 1.0);
  EXPECT_DOUBLE_EQ(cosine_of_turns(-0.5), -1.0);
}

TEST(Elementary, TheTurnsOfADirectionAgreeWithTheLibrary) {
  for (int k = 0; k <= 4000; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k / 4000.0 - 0.5);
    const double x = 3.0 * std::cos(angle), y = 3.0 * std::sin(angle);
    EXPECT_NEAR(atan2_turns(y, x), std::atan2(y, x) / (2.0 * std::numbers::pi), 4e-16) << angle;
  }
  EXPECT_EQ(atan2_turns(0.0, 0.0), 0.0);
  EXPECT_EQ(atan2_turns(0.0, 2.0), 0.0);
  EXPECT_EQ(atan2_turns(-2.0, 0.0), -0.25);
  EXPECT_EQ(atan2_turns(0.0, -2.0), 0.5);
}

TEST(Elementary, TheExponentialAgreesWithTheLibrary) {
  for (int k = -4000; k <= 4000; ++k) {
    const double x = k / 11.0;
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << x;
  }
  EXPECT_EQ(exponential(0.0), 1.0);
}

}  // namespace
}  // namespace taut::sim
