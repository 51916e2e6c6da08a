#include <gtest/gtest.h>

#include "app/drawing/inspection_picture.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "app/runs/frame_verifier.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/surface.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

/// A sheet with cells of 1 m, large enough for bodies that touch a triangle but none of its corners.
struct Sheet {
  std::shared_ptr<const sim::Garment> garment = sim::share(sim::make_garment(sim::make_grid(
      {.columns = 3, .rows = 3, .width_m = 2.0, .height_m = 2.0, .plane = sim::GridPlane::horizontal})));
  std::array<Vec3, 3> corners = sim::corner_positions(garment->mesh.triangles[5], garment->mesh.positions);
  Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;

  /// Crossing pairs and the message about them after one second.
  std::pair<std::size_t, std::string> found(const sim::Body& body) const {
    sim::Surroundings surroundings;
    surroundings.bodies = {body};
    FrameRecord record;
    record.frame = 60;
    record.time_s = 1.0;
    FrameVerifier verifier;
    const std::string broken = verifier.check(sim::Simulation(garment, {}, {}, surroundings), record);
    return {record.crossing_pairs.value(), broken};
  }
};

const Vec3 down(0.0, -1.0, 0.0);

TEST(FrameVerifier, CountsTheTrianglesInEachBody) {
  const Sheet sheet;
  for (const double depth_m : {0.01, -0.01}) {
    const std::size_t one = depth_m > 0.0 ? 1 : 0;
    const Vec3 centre = sheet.middle + (0.1 - depth_m) * down;
    EXPECT_EQ(sheet.found({.shape = sim::Sphere{centre, 0.1}}).first, one);
    EXPECT_EQ(sheet.found({.shape = sim::Capsule{centre, centre + down, 0.1, 0.05}}).first, one);
    EXPECT_EQ(sheet.found({.shape = sim::Plane{sheet.middle - depth_m * down, -down}}).first, 8 * one);
  }
  const std::string text = sheet.found({.shape = sim::Sphere{sheet.middle, 0.1}}).second;
  EXPECT_TRUE(
      text.starts_with("frame 60, 1.0000 s: 1 triangle enters body 0, the first: triangle 5 (vertices "))
      << text;
  EXPECT_EQ(sheet.found({.shape = sim::Sphere{sheet.middle + down, 0.1}}).second, "");
}

TEST(FrameVerifier, TakesBodiesWhereTheyAreInTheFrame) {
  const Sheet sheet;
  sim::Body ball = {.name = "ball", .shape = sim::Sphere{sheet.middle + down, 0.1}};
  EXPECT_EQ(sheet.found(ball).first, 0U);
  ball.motion.path = {{0.0, Vec3(0.0)}, {2.0, -2.0 * down}};
  const auto [count, text] = sheet.found(ball);
  EXPECT_EQ(count, 1U);
  EXPECT_CONTAINS(text, "1 triangle enters the body 'ball', the first");
}

TEST(FrameVerifier, CountsPairsWithTheTrianglesOfAMesh) {
  const Sheet sheet;
  const Vec3 p = sheet.middle + 0.7 * down, x(0.1, 0.0, 0.0), z(0.0, 0.0, 0.1);
  sim::Body body = {.name = "spike"};
  // The tip reaches through the sheet, the base does not.
  body.shape = sim::BodyMesh{std::make_shared<sim::BodyMeshData>(sim::BodyMeshData{
      {p - x - z, p + x - z, p + z, p - 0.8 * down}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}})};
  const auto [count, text] = sheet.found(body);
  EXPECT_EQ(count, 3U);
  EXPECT_CONTAINS(text, "3 pairs of triangles cross with the body 'spike', the first: triangle 5 (vertices ");
  EXPECT_CONTAINS(text, " and its triangle 1 (vertices 0, 3, 1) at [");
  body.motion.path = {{0.0, Vec3(0.0)}, {1.0, 0.2 * down}};
  EXPECT_EQ(sheet.found(body).second, "") << "drawn back by then";
}

TEST(FrameVerifier, LeavesOutWhatCrossesAtTheStartPairByPairUntilItIsApart) {
  const Sheet sheet;
  const auto corners = sim::corner_positions(sheet.garment->mesh.triangles[2], sheet.garment->mesh.positions);
  const Vec3 other = (corners[0] + corners[1] + corners[2]) / 3.0;
  sim::Surroundings surroundings;
  // The ball begins in triangle 5, goes down and out of it, comes back, and goes on to triangle 2.
  surroundings.bodies = {{.name = "ball", .shape = sim::Sphere{sheet.middle, 0.1}}};
  surroundings.bodies[0].motion.path = {
      {0.0, Vec3(0.0)}, {1.0, Vec3(0.0)}, {2.0, 0.5 * down}, {3.0, Vec3(0.0)}, {4.0, other - sheet.middle}};
  const sim::Simulation simulation(sheet.garment, {}, {}, surroundings);
  FrameVerifier verifier;
  const std::string at_start = verifier.begin(simulation);
  EXPECT_TRUE(at_start.starts_with("1 triangle enters the body 'ball', the first: triangle 5 (vertices "))
      << at_start;
  const auto check = [&](double time_s) {
    FrameRecord record;
    record.time_s = time_s;
    const std::string broken = verifier.check(simulation, record);
    return std::pair(record.crossing_pairs.value(), broken.substr(0, broken.find(" s: ")));
  };
  using Checked = std::pair<std::size_t, std::string>;
  EXPECT_EQ(check(0.0), Checked(0, ""));
  EXPECT_EQ(check(1.0), Checked(0, ""));
  EXPECT_CONTAINS(verifier.summary(), "0 crossing pairs outside what crosses since the start: 1 pairs then, 1 at the end,");
  FrameVerifier another;
  another.begin(simulation);
  FrameRecord moved;
  moved.time_s = 4.0;
  EXPECT_CONTAINS(another.check(simulation, moved), "triangle 2 (vertices ") << "another pair counts";
  EXPECT_EQ(check(2.0), Checked(0, ""));
  EXPECT_CONTAINS(verifier.summary(), "0 crossing pairs outside what crosses since the start: 1 pairs then, 0 at the end,");
  EXPECT_EQ(check(3.0), Checked(1, "frame 0, 3.0000")) << "it was apart";
}

TEST(FrameVerifier, LeavesOutOnlyPairsOfTheClothThatCrossAtTheStart) {
  sim::Mesh mesh = sim::make_grid(
      {.columns = 3, .rows = 3, .width_m = 2.0, .height_m = 2.0, .plane = sim::GridPlane::horizontal});
  const auto first = static_cast<sim::Index>(mesh.positions.size());
  const Vec3 in_cell = (mesh.positions[0] + mesh.positions[1] + mesh.positions[3] + mesh.positions[4]) / 4.0;
  for (const Vec3& offset : {Vec3(-0.1, -0.3, -0.2), Vec3(0.1, -0.3, -0.2), Vec3(0.0, 0.3, -0.2)}) {
    mesh.positions.push_back(in_cell + offset);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  const sim::Simulation crossing(sim::share(sim::make_garment(mesh)), {}, {}, {});
  FrameVerifier verifier;
  EXPECT_CONTAINS(verifier.begin(crossing), "pair");
  FrameRecord record;
  EXPECT_EQ(verifier.check(crossing, record), "");
  EXPECT_EQ(record.crossing_pairs, 0U);
  // The same triangle crosses another cell.
  sim::Checkpoint elsewhere = crossing.save();
  for (sim::Index v = first; v < first + 3; ++v) {
    elsewhere.state.current[v].x += 1.0;
  }
  sim::Simulation moved(sim::share(sim::make_garment(mesh)), {}, {}, {});
  moved.restore(elsewhere);
  EXPECT_CONTAINS(verifier.check(moved, record), "cross");
  EXPECT_GT(*record.crossing_pairs, 0U);
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
