#include <gtest/gtest.h>

#include "app/drawing/inspection_marks.hpp"
#include "app/models/inspection.hpp"
#include "app/output/frame_verifier.hpp"
#include "sim/mesh/grid.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

// Cells of 1 m; each body reaches a point within a triangle and no vertex.
TEST(FrameVerifier, CountsTheTrianglesInEachBody) {
  const auto sheet = sim::share(sim::make_garment(sim::make_grid(
      {.columns = 3, .rows = 3, .width_m = 2.0, .height_m = 2.0, .plane = sim::GridPlane::horizontal})));
  const auto& p = sheet->mesh.positions;
  const sim::Triangle& t = sheet->mesh.triangles[5];
  const Vec3 middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0, down(0.0, -1.0, 0.0);
  const auto found = [&](const sim::Shape& shape) {
    sim::Surroundings surroundings;
    surroundings.colliders = {{.shape = shape}};
    FrameRecord record;
    record.frame = 3;
    FrameVerifier verifier;
    const std::string broken = verifier.check(sim::Simulation(sheet, {}, {}, surroundings), record);
    return std::pair(record.crossing_pairs, broken);
  };
  for (const double depth_m : {0.01, -0.01}) {
    const std::size_t one = depth_m > 0.0 ? 1 : 0;
    const Vec3 centre = middle + (0.1 - depth_m) * down;
    EXPECT_EQ(found(sim::Sphere{centre, 0.1}).first, one);
    EXPECT_EQ(found(sim::Capsule{centre, centre + down, 0.1, 0.05}).first, one);
    EXPECT_EQ(found(sim::Plane{middle - depth_m * down, -down}).first, 8 * one);
  }
  const std::string text = found(sim::Sphere{middle, 0.1}).second;
  EXPECT_TRUE(
      text.starts_with("frame 3, 0.0000 s: 1 triangle enters body 0, the first: triangle 5 (vertices "))
      << text;
  EXPECT_EQ(found(sim::Sphere{middle + down, 0.1}).second, "");
}

TEST(FrameVerifier, HoldsStretchToTheBoundThatTheSolverPromises) {
  sim::BoundedSettings bound = {.bound = sim::BoundKind::surface, .max_stretch = 0.01};
  const auto said = [&](double springs, double surface) {
    sim::SolverSettings solver;
    solver.method = bound;
    return describe_excess({springs, surface}, solver);
  };
  EXPECT_EQ(said(0.01, 0.01), "");
  EXPECT_EQ(said(0.01001, 0.01001),
            "a spring is stretched by 1.0010000 %, more than solver.max_stretch = 1 %");
  EXPECT_TRUE(said(0.01, 0.01001).starts_with("a triangle is stretched by 1.0010000 %"));
  EXPECT_TRUE(said(std::nan(""), 0.0).starts_with("a spring is stretched by nan"));
  bound.bound = sim::BoundKind::springs;
  EXPECT_EQ(said(0.01, 0.2), "");
  bound.allow_exceeding = true;
  EXPECT_EQ(said(0.2, 0.2), "");
}

TEST(FrameVerifier, ReportsItsInspectionWithMarksOnBothTriangles) {
  const test::TemporaryFolder folder;
  Scene scene;
  scene.garment.file =
      folder.write("crosses.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv .2 .2 -1\nv .2 .2 1\nv .9 .9 1\nv 5 0 0\nv 6 0 0\n"
                   "v 5 1 0\nf 1 2 3\nf 7 8 9\nf 4 5 6\n");
  const LoadedGarment loaded = load_garment(scene);
  const Inspection inspection = inspect_garment(scene, loaded);
  ASSERT_EQ(inspection.crossings.size(), 1U);
  const auto all = inspection_marks(loaded, inspection.crossings, {});
  const auto marks = std::find_if(all.begin(), all.end(), [](const InspectionMarks& m) {
    return m.meaning == "pairs of triangles that cross: 1";
  });
  ASSERT_NE(marks, all.end());
  std::vector<glm::vec3> expected;
  for (const std::size_t triangle : {0U, 2U}) {
    const sim::Triangle& t = loaded.garment->mesh.triangles[triangle];
    for (const std::size_t corner : {0U, 1U, 1U, 2U, 2U, 0U}) {
      expected.emplace_back(loaded.garment->mesh.positions[t[corner]]);
    }
  }
  EXPECT_EQ(marks->points, expected);
  EXPECT_TRUE(marks->seen_through);
}

}  // namespace
}  // namespace taut::app
