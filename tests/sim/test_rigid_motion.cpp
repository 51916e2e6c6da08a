#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/rigid_motion.hpp"

namespace taut::sim {
namespace {

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_LT(glm::length(found - expected), 1e-15) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(RigidMotion, StaysWhereItIsByItself) {
  const Vec3 p = {0.1, 0.2, 0.3};
  EXPECT_EQ(pose_at({}, 7.0)(p), p);
  EXPECT_FALSE(is_moving_after({}, 0.0));
}

TEST(RigidMotion, ShiftsFromOneTimeUntilAnother) {
  const RigidMotion motion = {.shift = {{2.0, 0.0, -1.0}, 1.0, 3.0}};
  expect_near(pose_at(motion, 0.5).offset_m, {0.0, 0.0, 0.0});
  expect_near(pose_at(motion, 2.5).offset_m, {3.0, 0.0, -1.5});
  expect_near(pose_at(motion, 9.0).offset_m, {4.0, 0.0, -2.0});
  EXPECT_TRUE(is_moving_after(motion, 0.0)) << "it has not begun";
  EXPECT_TRUE(is_moving_after(motion, 2.9));
  EXPECT_FALSE(is_moving_after(motion, 3.0));
}

TEST(RigidMotion, SpinsCounterClockwiseAboutItsLine) {
  const RigidMotion motion = {.spin = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.25, 0.0, 2.0}};
  expect_near(pose_at(motion, 1.0)({2.0, 0.0, 5.0}), {1.0, 1.0, 5.0});
  expect_near(pose_at(motion, 2.0)({2.0, 0.0, 5.0}), {0.0, 0.0, 5.0});
  expect_near(pose_at(motion, 7.0)({2.0, 0.0, 5.0}), {0.0, 0.0, 5.0});
  expect_near(pose_at({.spin = {{}, {1.0, 0.0, 0.0}, 0.25}}, 1.0)({0.0, 1.0, 0.0}), {0.0, 0.0, 1.0});
  expect_near(pose_at({.spin = {{}, {0.0, 1.0, 0.0}, 0.25}}, 1.0)({0.0, 0.0, 1.0}), {1.0, 0.0, 0.0});
  const double third = std::sqrt(1.0 / 3.0);
  expect_near(pose_at({.spin = {{}, {third, third, third}, 1.0}}, 1.0 / 3.0)({1.0, 0.0, 0.0}),
              {0.0, 1.0, 0.0});
  EXPECT_TRUE(is_moving_after(motion, 1.0));
  EXPECT_FALSE(is_moving_after(motion, 2.0));
}

TEST(RigidMotion, FollowsItsPathAndIsHeldBeforeAndAfterIt) {
  const RigidMotion motion = {
      .path = {{1.0, {1.0, 0.0, 0.0}}, {2.0, {1.0, 4.0, 0.0}}, {3.0, {1.0, 4.0, 0.0}}}};
  EXPECT_EQ(pose_at(motion, 0.0).offset_m, Vec3(1.0, 0.0, 0.0));
  EXPECT_EQ(pose_at(motion, 1.25).offset_m, Vec3(1.0, 1.0, 0.0));
  EXPECT_EQ(pose_at(motion, 2.0).offset_m, Vec3(1.0, 4.0, 0.0));
  EXPECT_EQ(pose_at(motion, 8.0).offset_m, Vec3(1.0, 4.0, 0.0));
  EXPECT_TRUE(is_moving_after(motion, 1.9));
  EXPECT_FALSE(is_moving_after(motion, 2.0)) << "it is held from there on";
}

TEST(RigidMotion, IsTurnedBeforeItIsMoved) {
  const RigidMotion motion = {
      .shift = {{1.0, 0.0, 0.0}}, .spin = {{}, {0.0, 0.0, 1.0}, 0.25}, .path = {{0.0, {0.0, 0.0, 7.0}}}};
  expect_near(pose_at(motion, 1.0)({1.0, 0.0, 0.0}), {1.0, 1.0, 7.0});
}

TEST(RigidMove, CarriesAPointFromWhereItIsNow) {
  const RigidMotion motion = {.shift = {{3.0, 0.0, 0.0}}, .spin = {{}, {0.0, 0.0, 1.0}, 0.25}};
  const Vec3 at_1_s = pose_at(motion, 1.0)({1.0, 0.5, 0.25});
  const Vec3 at_3_s = pose_at(motion, 3.0)({1.0, 0.5, 0.25});
  expect_near(at_1_s + RigidMove(motion, {1.0, 3.0}).displacement_m(at_1_s), at_3_s);
  expect_near(at_3_s + RigidMove(motion, {3.0, 1.0}).displacement_m(at_3_s), at_1_s);
}

TEST(RigidMove, IsExactlyNothingWhereNothingMoves) {
  const RigidMotion motion = {.spin = {{0.1, 0.2, 0.3}, {0.0, 0.6, 0.8}, 0.3, 0.0, 1.0}};
  EXPECT_EQ(RigidMove(motion, {1.5, 2.0}).displacement_m({0.7, 0.7, 0.7}), Vec3(0.0));
}

}  // namespace
}  // namespace taut::sim
