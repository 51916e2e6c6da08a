#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sweeps/sweep.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::message_of;
using test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr const char* sheet = R"(
[garment.grid]
columns = 4
rows = 4
width = 0.3
height = 0.3
[pins]
at = ["top-left"]
[[pins.moving]]
at = ["top-right"]
shift = { velocity = [0.4, 0.0, 0.0], until = 0.2 }
[solver]
kind = "bounded"
max_substeps = 20
)";
constexpr const char* axes = R"(
scene = "scene.toml"
frames = 20
[axes]
"solver.max_stretch" = [0.6, 0.05]
wind.speed = [0, 1.5, 3]
)";

class SweepTest : public testing::Test {
 protected:
  SweepTest() { folder.write("scene.toml", sheet); }

  Sweep planned(const std::string& study, const std::string& name = "sweep") {
    plan_sweep(folder.write("study.toml", study), folder / name);
    return read_sweep(folder / name);
  }

  std::string refusal(const std::string& values) {
    return message_of<InputError>(
        [&] { planned("scene = \"scene.toml\"\n[axes]\nwind.speed = [0]\n" + values + '\n'); });
  }

  TemporaryFolder folder;
};

TEST_F(SweepTest, TheLastAxisCountsFastest) {
  const Sweep sweep = planned(axes);
  ASSERT_EQ(sweep.runs.size(), 6U);
  EXPECT_EQ(sweep.runs[0].values.dump(), R"({"solver.max_stretch":0.6,"wind.speed":0})");
  EXPECT_EQ(sweep.runs[2].values.dump(), R"({"solver.max_stretch":0.6,"wind.speed":3})");
  const DrawnScene scene = read_scene_file(sweep.file(4, ".toml"));
  EXPECT_EQ(scene.surroundings.forces.wind.speed_m_per_s, 1.5);
  EXPECT_EQ(scene.simulation.solver.bounded.max_stretch, 0.05);
  EXPECT_EQ(scene.frames, 20);
  EXPECT_EQ(scene.garment.grid.columns, 4U);
}

TEST_F(SweepTest, AFabricGivesWayToTheOtherAxes) {
  const Sweep sweep =
      planned("scene = \"scene.toml\"\n[axes]\ncloth.thickness = [0.0007]\ncloth.fabric = [\"denim\"]\n");
  const DrawnScene scene = read_scene_file(sweep.file(0, ".toml"));
  EXPECT_EQ(scene.fabric, "denim");
  EXPECT_EQ(scene.material.thickness_m, 0.0007);
  EXPECT_EQ(scene.material.areal_density_kg_per_m2, material_of("denim", "").areal_density_kg_per_m2);
}

TEST_F(SweepTest, SaysWhichLineOfAStudyIsWrong) {
  EXPECT_CONTAINS(refusal("solver.substep = [4]"), "study.toml:4: unknown key 'solver.substep'; did you mean");
  EXPECT_CONTAINS(refusal("solver.substeps = [4,\n\"many\"]"), "study.toml:5: solver.substeps: found \"many\"");
  EXPECT_CONTAINS(refusal("solver.substeps = 4"), "study.toml:4: solver.substeps: found 4, expected a list");
  EXPECT_CONTAINS(refusal("solver.substeps = []"), "expected a list of values");
  EXPECT_CONTAINS(refusal("garment.file = [\"none.obj\"]"), "study.toml:4: garment.file: there is no file '");
  EXPECT_FALSE(fs::exists(folder / "sweep")) << "something was written";
}

TEST_F(SweepTest, CombinationsThatCannotBePromisedAreRefused) {
  EXPECT_CONTAINS(refusal("wind.gust_amplitude = [0.0, 1.0]\nwind.direction = [[0, 0, 1]]\n"
                          "solver.max_stretch = [0.00001]\n\"wind.pressure\" = [1]\n\"wind.speed\" = [50]"),
                  "study.toml");
}

TEST_F(SweepTest, PlannedAgainNothingChangesAndAnotherStudyIsRefused) {
  planned(axes);
  const std::string before = read_text_file(folder / "sweep/sweep.json");
  planned(axes);
  EXPECT_EQ(read_text_file(folder / "sweep/sweep.json"), before);
  EXPECT_CONTAINS(message_of<InputError>([&] { planned(std::string(axes) + "air.drag = [1]\n"); }),
                  "holds the sweep of another study");
  EXPECT_EQ(read_text_file(folder / "sweep/sweep.json"), before);
}

TEST_F(SweepTest, AFolderThatHoldsNoSweepIsRefused) {
  const fs::path nowhere = (folder / "sweep.json").parent_path();
  const auto refused = [&] { return message_of<InputError>([&] { read_sweep(nowhere); }); };
  EXPECT_CONTAINS(refused(), "there is no sweep.json; taut sweep plan makes one");
  folder.write("sweep.json", R"({"program": "0123", "runs": []})");
  EXPECT_CONTAINS(refused(), "sweep.json' names no run");
  folder.write("sweep.json", std::string(100000, '[') + std::string(100000, ']'));
  EXPECT_CONTAINS(refused(), "nested more than 100 deep");
  folder.write("sweep.json", "{\"runs\": 1}");
  EXPECT_EQ(refused().find("exception"), std::string::npos) << refused();
  folder.write("sweep.json", R"({"program": "0123", "runs": [{"values")");
  EXPECT_CONTAINS(refused(), "cannot read the sweep in '");
}

TEST_F(SweepTest, FilesAreFoundBesideTheStudy) {
  fs::create_directory(folder / "models");
  const fs::path garment = find_asset("tshirt_1028").value();
  fs::copy(garment, folder / "models/shirt.obj");
  folder.write("worn.toml",
               "[garment]\nfile = \"models/shirt.obj\"\n[[bodies]]\nshape = \"mesh\"\nfile = \"needles\"\n");
  const Sweep sweep = planned(
      "scene = \"worn.toml\"\n[axes]\ngarment.file = [\"models/shirt.obj\", \"tshirt_5280\"]\n"
      "bodies = [[], [{ shape = \"mesh\", file = \"needles\" }]]\n");
  const DrawnScene scene = read_scene_file(sweep.file(1, ".toml"));
  EXPECT_EQ(scene.garment.file, fs::absolute(folder / "models/shirt.obj"));
  ASSERT_EQ(scene.body_sources.size(), 1U);
  EXPECT_TRUE(fs::exists(scene.body_sources[0].file)) << scene.body_sources[0].file;
  EXPECT_EQ(read_scene_file(sweep.file(2, ".toml")).garment.file.stem(), "tshirt_5280");
  EXPECT_EQ(read_scene_file(sweep.file(2, ".toml")).body_sources.size(), 0U);
}

TEST_F(SweepTest, ResultsOfAnotherSceneOrProgramDoNotCount) {
  Sweep sweep = planned(axes);
  ASSERT_EQ(attempt_run(sweep, 0).end, RunEnd::done);
  EXPECT_EQ(ranges_text(status_of(sweep).missing), "1-5");
  fs::copy(sweep.file(0, ".json"), sweep.file(1, ".json"));
  EXPECT_FALSE(result_of(sweep, 1)) << "it is of run 0";
  sweep.program = "another";
  EXPECT_FALSE(result_of(sweep, 0));
  EXPECT_EQ(status_of(sweep).missing.size(), 6U);
  EXPECT_CONTAINS(message_of<InputError>([&] { require_planned_program(sweep); }), "planned for the program another");
}

TEST_F(SweepTest, AChangedSceneOrGarmentIsSaidAndPlannedAnew) {
  fs::copy(find_asset("tshirt_1028").value(), folder / "shirt.obj");
  const std::string study = "scene = \"shirt.obj\"\nframes = 1\n[axes]\nwind.speed = [0, 1]\n";
  const Sweep sweep = planned(study);
  ASSERT_EQ(attempt_run(sweep, 0).end, RunEnd::done);
  std::ofstream(folder / "shirt.obj", std::ios::app) << "# changed\n";
  EXPECT_CONTAINS(message_of<InputError>([&] { attempt_run(sweep, 1); }), "is not as it was planned");
  EXPECT_EQ(status_of(planned(study)).missing.size(), 2U);
  EXPECT_EQ(attempt_run(read_sweep(folder / "sweep"), 1).end, RunEnd::done);
  std::ofstream(sweep.file(0, ".toml"), std::ios::app) << "# changed\n";
  EXPECT_CONTAINS(message_of<InputError>([&] { attempt_run(read_sweep(folder / "sweep"), 0); }), "as it was planned");
}

TEST_F(SweepTest, ABrokenPromiseIsAResult) {
  const Sweep sweep = planned(axes);
  const Attempt attempt = attempt_run(sweep, 3);
  EXPECT_EQ(attempt.end, RunEnd::broken);
  EXPECT_CONTAINS(attempt.reason, "exceed solver.max_stretch = 0.05");
  const std::optional<Json> result = result_of(sweep, 3);
  ASSERT_TRUE(result);
  EXPECT_EQ((*result)["end"], "broken");
  EXPECT_EQ((*result)["reason"], attempt.reason);
  EXPECT_GT((*result)["max_stretch"], 0.05);
  EXPECT_EQ(status_of(sweep).ended[1], 1U);
  EXPECT_EQ(attempt_run(sweep, 3).end, RunEnd::broken) << "found again";
}

TEST_F(SweepTest, ARunThatCannotGoOnIsBroken) {
  const Sweep sweep = planned("scene = \"" TAUT_TESTS_FOLDER
                              "/contact/closing_spheres.toml\"\n[axes]\nwind.speed = "
                              "[0]\ngarment.grid.columns = [7]\ngarment.grid.rows = [7]\n");
  const Attempt attempt = attempt_run(sweep, 0);
  EXPECT_EQ(attempt.end, RunEnd::broken);
  EXPECT_CONTAINS(attempt.reason, "something would cross");
}

TEST_F(SweepTest, WhatFailedIsSaidAndTriedAgain) {
  const Sweep sweep = planned("scene = \"scene.toml\"\n[axes]\npins.at = [[\"nowhere\"], [\"top-left\"]]\n");
  EXPECT_EQ(attempt_run(sweep, 0).end, RunEnd::failed);
  const SweepStatus status = status_of(sweep);
  EXPECT_EQ(status.ended[2], 1U);
  EXPECT_EQ(ranges_text(status.missing), "0-1");
  EXPECT_CONTAINS(status.first_failure, "run 0: ");
  EXPECT_EQ(attempt_run(sweep, 0).end, RunEnd::failed);
}

struct Stop {};

TEST_F(SweepTest, AStoppedRunGoesOnWithTheSameBits) {
  const std::string study =
      "scene = \"scene.toml\"\nframes = 90\n[axes]\nwind.speed = [4]\nsolver.max_stretch = [0.6]\n";
  const Sweep sweep = planned(study);
  const auto stop = [](double fraction) {
    if (fraction > 0.5) {
      throw Stop{};
    }
  };
  EXPECT_THROW(attempt_run(sweep, 0, stop), Stop);
  EXPECT_FALSE(result_of(sweep, 0));
  EXPECT_TRUE(fs::exists(sweep.file(0, ".checkpoint")));
  double first = 0.0;
  const auto note_first = [&](double fraction) { first = first > 0.0 ? first : fraction; };
  ASSERT_EQ(attempt_run(sweep, 0, note_first).end, RunEnd::done);
  EXPECT_GT(first, 0.5) << "it began anew";
  EXPECT_FALSE(fs::exists(sweep.file(0, ".checkpoint")));
  const Sweep whole = planned(study, "whole");
  ASSERT_EQ(attempt_run(whole, 0).end, RunEnd::done);
  for (const char* name : {"state_hash", "frames", "max_stretch", "smallest_distance"}) {
    EXPECT_EQ((*result_of(sweep, 0))[name], (*result_of(whole, 0))[name]) << name;
  }
}

TEST_F(SweepTest, ADamagedCheckpointIsNotUsed) {
  const Sweep sweep = planned(axes);
  write_text_file(sweep.file(0, ".checkpoint"), "TAUTRUN\nand then nothing");
  EXPECT_EQ(attempt_run(sweep, 0).end, RunEnd::done);
}

TEST_F(SweepTest, TheTableHasEveryRun) {
  const Sweep sweep = planned(axes);
  attempt_run(sweep, 1);
  const std::string table = sweep_table(sweep);
  EXPECT_CONTAINS(table, "index,solver.max_stretch,wind.speed,end,frames,max_stretch,");
  EXPECT_CONTAINS(table, "\n0,0.6,0,missing,,");
  EXPECT_CONTAINS(table, "\n1,0.6,1.5,done,20,0.");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
}

TEST(Farm, RangesAreThoseOfSlurm) {
  EXPECT_EQ(ranges_text({}), "");
  EXPECT_EQ(ranges_text(std::vector<std::size_t>{3, 7, 8, 9, 12}), "3,7-9,12");
}

}  // namespace
}  // namespace taut::app
