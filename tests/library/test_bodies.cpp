#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include "cloths.hpp"
#include "temporary_folder.hpp"

namespace taut::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double min_height(const OwnCloth& cloth) {
  double y = infinite;
  for (const auto& position : cloth.positions()) {
    y = std::min(y, position[1]);
  }
  return y;
}

TEST(Library, ClothFallsOnThePlaneAndIsLiftedByABodyThatMoves) {
  Square square(9, 0.15, 0.02);
  square.options.counts_crossings = 1;
  OwnCloth cloth(square.options);
  auto plane = make_struct<TautBody>(taut_body_init);
  plane.plane_normal[1] = 3.0;
  std::int32_t number = -1;
  ASSERT_EQ(taut_add_body(cloth, &plane, &number), TAUT_OK) << cloth.error();
  EXPECT_EQ(number, 0);
  EXPECT_EQ(taut_move_body(cloth, 0, &square.mesh.positions), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_move_body(cloth, -1, &square.mesh.positions), TAUT_ERROR_ARGUMENT);
  Box box(-0.15);
  ASSERT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_OK) << cloth.error();
  EXPECT_EQ(number, 1);
  cloth.step(20);
  EXPECT_GT(min_height(cloth), 0.0);
  EXPECT_LT(min_height(cloth), 0.01);
  for (int frame = 0; frame < 20; ++frame) {
    box.lift(0.01);
    ASSERT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_OK) << cloth.error();
    const TautFrame made_frame = cloth.step();
    ASSERT_EQ(cloth.result, TAUT_OK) << cloth.error();
    EXPECT_EQ(made_frame.crossing_pairs, 0);
    EXPECT_LT(made_frame.smallest_distance_m, 0.02);
  }
  EXPECT_GT(min_height(cloth), 0.15);
  box.lift(2.0);
  EXPECT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_ERROR_ARGUMENT);
  EXPECT_CONTAINS(cloth.error(), "m from where it is, expected at most 1 m in a frame");
  EXPECT_EQ(taut_place_body(cloth, number, &box.mesh.positions), TAUT_OK);
  box.mesh.corner_count = 20;
  box.mesh.face_count = 5;
  EXPECT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_ERROR_INPUT);
  EXPECT_CONTAINS(cloth.error(), "a body has no holes");
}

TEST(Library, AFrameThatCannotBeMadeLeavesTheClothAsItWas) {
  Square square(5, 0.1, 0.3);
  OwnCloth cloth(square.options);
  std::vector<std::uint32_t> all(25);
  std::iota(all.begin(), all.end(), 0U);
  ASSERT_EQ(taut_set_pins(cloth, all.data(), all.size()), TAUT_OK);
  Box box(0.1);
  std::int32_t number = 0;
  ASSERT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_OK);
  cloth.step();
  const std::uint64_t hash = cloth.hash();
  box.lift(0.3);
  ASSERT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_OK);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_ERROR_PROMISE);
  EXPECT_CONTAINS(cloth.error(), "box");
  EXPECT_EQ(cloth.hash(), hash);
  EXPECT_EQ(cloth.info().frame, 1);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_OK) << "the body stayed too: " << cloth.error();
}

using Lines = std::vector<std::string>;

void keep_line(void* lines, const char* text) {
  static_cast<Lines*>(lines)->emplace_back(text);
}

/// A square that crosses the middle of a box. Its log messages are recorded.
struct LibraryCrossing : testing::Test {
  LibraryCrossing() {
    square.options.log = keep_line;
    square.options.log_user = &lines;
    square.options.bodies = bodies;
  }

  Lines lines;
  Square square{9, 0.3, 0.1};
  Box box{0.1};
  const TautBody* bodies[1] = {&box.body};
};

TEST_F(LibraryCrossing, OfABodyThatIsAddedIsTold) {
  OwnCloth cloth(square.options);
  EXPECT_EQ(cloth.info().crossings_at_start, 0U);
  EXPECT_TRUE(lines.empty());
  ASSERT_EQ(taut_add_body(cloth, &box.body, nullptr), TAUT_OK) << cloth.error();
  EXPECT_GT(cloth.info().crossings_at_start, 20U);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_CONTAINS(lines[0], "at the start " + std::to_string(cloth.info().crossings_at_start) +
                                " pairs of triangles cross with the body 'box', the first: triangle ");
  EXPECT_EQ(cloth.positions(), square.positions) << "nothing is moved";
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_OK) << cloth.error();
}

TEST_F(LibraryCrossing, OfABodyThatIsThereFromTheStartIsTold) {
  square.options.body_count = 1;
  OwnCloth cloth(square.options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_CONTAINS(lines[0],
                  std::to_string(cloth.info().crossings_at_start) + " pairs of triangles cross with");
  EXPECT_EQ(cloth.info().body_count, 1U);
}

TEST_F(LibraryCrossing, OfABodyThatIsAddedIsNoneThatCountsLater) {
  square.options.counts_crossings = 1;
  OwnCloth added(square.options);
  ASSERT_EQ(taut_add_body(added, &box.body, nullptr), TAUT_OK) << added.error();
  square.options.body_count = 1;
  OwnCloth at_once(square.options);
  const TautFrame after = added.step(), expected = at_once.step();
  EXPECT_EQ(after.crossing_pairs, expected.crossing_pairs);
  EXPECT_LT(after.crossing_pairs, 10) << "those that begin to cross as it falls";
  EXPECT_EQ(added.hash(), at_once.hash());
}

TEST_F(LibraryCrossing, APlanePushesClothOut) {
  OwnCloth cloth(square.options);
  auto plane = make_struct<TautBody>(taut_body_init);
  plane.plane_normal[1] = 1.0;
  plane.plane_point[1] = 0.11;
  ASSERT_EQ(taut_add_body(cloth, &plane, nullptr), TAUT_OK);
  EXPECT_EQ(cloth.info().crossings_at_start, cloth.info().triangle_count);
  EXPECT_EQ(lines.size(), 1U);
  cloth.step();
  EXPECT_GT(min_height(cloth), 0.11);
}

TEST_F(LibraryCrossing, CountsClothThatIsWhollyWithin) {
  Square small(3, 0.1, 0.1);
  small.options.log = keep_line;
  small.options.log_user = &lines;
  OwnCloth cloth(small.options);
  ASSERT_EQ(taut_add_body(cloth, &box.body, nullptr), TAUT_OK) << cloth.error();
  EXPECT_EQ(cloth.info().crossings_at_start, 1U);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_CONTAINS(lines[0], "1 part of the cloth is wholly within the body 'box'");
}

// A caller with these options may have freed its log after the cloth was made.
TEST_F(LibraryCrossing, IsNotLoggedToCallersThatKnowNoBodiesOfOptions) {
  square.options.struct_size = offsetof(TautOptions, bodies);
  OwnCloth cloth(square.options);
  ASSERT_EQ(taut_add_body(cloth, &box.body, nullptr), TAUT_OK) << cloth.error();
  EXPECT_GT(cloth.info().crossings_at_start, 0U);
  EXPECT_TRUE(lines.empty());
}

TEST_F(LibraryCrossing, IsThatOfTheStartThatIsGiven) {
  const Square above(9, 0.3, 0.3);
  const TautPoints start = above.points();
  square.options.start = &start;
  square.options.body_count = 1;
  OwnCloth cloth(square.options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  EXPECT_EQ(cloth.info().crossings_at_start, 0U);
  EXPECT_EQ(cloth.positions()[0][1], 0.3);
  EXPECT_TRUE(lines.empty());
}

TEST_F(LibraryCrossing, OfAStartWithItselfIsPartedWhereThatIsAskedFor) {
  // The last column lies across the column before it.
  Square folded(9, 0.3, 0.5);
  for (std::size_t v = 8; v < folded.positions.size(); v += 9) {
    folded.positions[v][0] -= 0.06;
    folded.positions[v][1] += v % 2 != 0 ? 0.002 : -0.002;
  }
  const TautPoints start = folded.points();
  square.options.start = &start;
  EXPECT_GT(OwnCloth(square.options).info().crossings_at_start, 0U);
  const char* setting = "garment.untangle = true";
  square.options.settings = &setting;
  square.options.setting_count = 1;
  lines.clear();
  OwnCloth parted(square.options);
  ASSERT_EQ(parted.result, TAUT_OK) << parted.text;
  ASSERT_FALSE(lines.empty());
  EXPECT_CONTAINS(lines[0], "that crossed at the start 0 are left");
  EXPECT_EQ(parted.info().crossings_at_start, 0U);
}

TEST_F(LibraryCrossing, BodiesOfOptionsAreLedAndRefusedAsThoseThatAreAdded) {
  Box low(-0.3);
  bodies[0] = &low.body;
  square.options.body_count = 1;
  OwnCloth cloth(square.options);
  low.lift(0.1);
  EXPECT_EQ(taut_move_body(cloth, 0, &low.mesh.positions), TAUT_OK) << cloth.error();
  EXPECT_EQ(cloth.step().is_contact_kept, 1);
  low.body.dress = 30;
  OwnCloth dressed(square.options);
  EXPECT_EQ(dressed.result, TAUT_ERROR_INPUT);
  EXPECT_CONTAINS(dressed.text, "'box': found a body to be dressed (dress, --dress) without joints");
  EXPECT_EQ(taut_add_body(cloth, &low.body, nullptr), TAUT_ERROR_INPUT);
  bodies[0] = nullptr;
  OwnCloth none(square.options);
  EXPECT_EQ(none.result, TAUT_ERROR_ARGUMENT);
  square.options.bodies = nullptr;
  OwnCloth fewer(square.options);
  EXPECT_EQ(fewer.result, TAUT_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace taut::test
