#include <gtest/gtest.h>

#include <cmath>

#include "app/base/errors.hpp"
#include "app/models/reading/model_arrays.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;

std::string error_text(const std::string& text) {
  return error_message<InputError>([&] { read_obj(text); });
}

TEST(ObjReading, KeepsEveryDigit) {
  const ModelArrays model =
      read_obj("v 0.1 0.30000000000000004 1e-17\nv 1.0000000000000002 0 0\nv 0 1 0\nf 1 2 3\n").value();
  EXPECT_EQ(model.positions[0], sim::Vec3(0.1, 0.30000000000000004, 1e-17));
  EXPECT_EQ(model.positions[1].x, 1.0000000000000002);
}

TEST(ObjReading, TakesEveryWayToNameAVertex) {
  const ModelArrays model =
      read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1 2//1 3/1/1 -1\n").value();
  EXPECT_EQ(model.faces.corner_counts, std::vector<std::uint32_t>{4});
  EXPECT_EQ(model.faces.corners, (std::vector<sim::Index>{0, 1, 2, 3}));
  EXPECT_EQ(model.positions[3], sim::Vec3(0, 1, 0));
}

TEST(ObjReading, NumbersVerticesByTheirFirstUse) {
  const ModelArrays model = read_obj("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 4 2 3\n").value();
  EXPECT_EQ(model.faces.corners, (std::vector<sim::Index>{0, 1, 2}));
  EXPECT_EQ(model.positions[0], sim::Vec3(0, 1, 0));
  ASSERT_EQ(model.positions.size(), 4U);
  EXPECT_EQ(model.positions[3], sim::Vec3(9, 9, 9));
}

TEST(ObjReading, TakesLinesAsProgramsWriteThem) {
  const ModelArrays model =
      read_obj("\xEF\xBB\xBF# f 7 8 9\r\nv\t0 0 0 # first\r\n  v +1 .5 -2E3\rv 0 1 0 0.2 0.3 0.4\nf 1 2 \\\n3").value();
  EXPECT_EQ(model.positions[1], sim::Vec3(1, 0.5, -2000));
  EXPECT_EQ(model.faces.corners, (std::vector<sim::Index>{0, 1, 2}));
}

TEST(ObjReading, AFaceMayComeBeforeItsVertices) {
  EXPECT_EQ(read_obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")->positions.size(), 3U);
}

TEST(ObjReading, CountsWhatItPassesOver) {
  const ModelArrays model = read_obj(
                                "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\np 1 2\nf 1 2\nf 3\nf 1 2 3\ng "
                                "b\nusemtl c\nf 3 2 1\ng d\n")
                                .value();
  EXPECT_EQ(model.ignored_lines, 3U);
  EXPECT_EQ(model.ignored_points, 3U);
  EXPECT_EQ(model.meshes, 2U);
  EXPECT_EQ(model.faces.corner_counts.size(), 2U);
}

TEST(ObjReading, LeavesOtherFilesAlone) {
  EXPECT_FALSE(read_obj("").has_value());
  EXPECT_FALSE(read_obj("Once upon a time there was a dress.\n").has_value());
}

TEST(ObjReading, NumbersOutOfRangeAreWhatTheyRoundTo) {
  const ModelArrays model = read_obj("v 1e999 1e-999 0\n").value();
  EXPECT_TRUE(std::isinf(model.positions[0].x));
  EXPECT_EQ(model.positions[0].y, 0.0);
}

TEST(ObjReading, SaysWhichLineIsDamaged) {
  EXPECT_CONTAINS(error_text("v 0 0 0\n\nv 1 zero 0\n"), "line 3: found 'zero', expected a coordinate of a vertex");
  EXPECT_CONTAINS(error_text("v 1 0,5 0\n"), "line 1: found '0,5'");
  EXPECT_CONTAINS(error_text("v 1 2\n"), "line 1: found '', expected a coordinate");
  EXPECT_CONTAINS(error_text("v 0 0 0\nf 1 \\\n1 \\\n1\nf 1 x 1\n"),
                  "line 5: found 'x', expected the number of a vertex");
  EXPECT_CONTAINS(error_text("v 0 0 0\nf 1 0 1\n"), "line 2: found '0'");
  EXPECT_CONTAINS(error_text("v 0 0 0\nf 1 -2 1\n"), "line 2: found '-2'");
  EXPECT_CONTAINS(error_text("v 0 0 0\nf 1 99999999999999999999 1\n"), "line 2: found '9999");
  EXPECT_CONTAINS(error_text("v 0 0 0\nf 1 7 1\nf 1 1 1\n"), "line 2: a face uses vertex 7 of a model that has 1");
}

}  // namespace
}  // namespace taut::app
