#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/sweeps/sweep_run.hpp"
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
    const PlannedSweep plan = plan_sweep(folder.write("study.toml", study), folder / name);
    write_sweep(plan);
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
  ASSERT_EQ(sweep.runs(), 6U);
  EXPECT_EQ(sweep.describe(0), "solver.max_stretch = 0.6, wind.speed = 0");
  EXPECT_EQ(sweep.describe(2), "solver.max_stretch = 0.6, wind.speed = 3");
  EXPECT_EQ(sweep.describe(4), "solver.max_stretch = 0.05, wind.speed = 1.5");
  const DrawnScene scene = sweep.scene(4);
  EXPECT_EQ(scene.surroundings.forces.wind.speed_m_per_s, 1.5);
  EXPECT_EQ(scene.simulation.solver.bounded.max_stretch, 0.05);
  EXPECT_EQ(scene.frames, 20);
  EXPECT_EQ(scene.garment.grid.columns, 4U);
}

TEST_F(SweepTest, TheManifestHasALineForEachRun) {
  const Sweep sweep = planned(axes);
  std::istringstream lines(read_text_file(folder / "sweep/manifest"));
  std::size_t run = 0;
  for (std::string line; std::getline(lines, line); ++run) {
    const Json json = Json::parse(line);
    EXPECT_EQ(json["index"], run);
    EXPECT_EQ(json["values"], sweep.values(run));
    EXPECT_EQ(json["scene"], sweep.scene_hash(run));
    EXPECT_EQ(json["program"], program_hash());
  }
  EXPECT_EQ(run, 6U);
}

TEST_F(SweepTest, SaysWhichLineOfAStudyIsWrong) {
  EXPECT_CONTAINS(refusal("solver.substep = [4]"), "study.toml:4: unknown key 'solver.substep'; did you mean");
  EXPECT_CONTAINS(refusal("solver.substeps = [4,\n\"many\"]"), "study.toml:5: solver.substeps: found \"many\"");
  EXPECT_CONTAINS(refusal("solver.substeps = 4"), "study.toml:4: solver.substeps: found 4, expected a list");
  EXPECT_CONTAINS(refusal("solver.substeps = []"), "expected a list of values");
  EXPECT_CONTAINS(refusal("garment.file = [\"none.obj\"]"), "there is no file 'none.obj'");
  EXPECT_FALSE(fs::exists(folder / "sweep")) << "something was written";
}

TEST_F(SweepTest, CombinationsThatCannotBePromisedAreRefused) {
  EXPECT_CONTAINS(refusal("wind.gust_amplitude = [0.0, 1.0]\nwind.direction = [[0, 0, 1]]\n"
                          "solver.max_stretch = [0.00001]\n\"wind.pressure\" = [1]\n\"wind.speed\" = [50]"),
                  "study.toml");
}

TEST_F(SweepTest, PlannedAgainNothingChangesAndAnotherStudyIsRefused) {
  const fs::path study = folder.write("study.toml", axes);
  EXPECT_TRUE(write_sweep(plan_sweep(study, folder / "sweep")));
  const std::string before = read_text_file(folder / "sweep/sweep.json");
  EXPECT_FALSE(write_sweep(plan_sweep(study, folder / "sweep")));
  EXPECT_EQ(read_text_file(folder / "sweep/sweep.json"), before);
  const fs::path other = folder.write("other.toml", std::string(axes) + "air.drag = [1]\n");
  EXPECT_CONTAINS(message_of<InputError>([&] { write_sweep(plan_sweep(other, folder / "sweep")); }),
                  "holds the sweep of another study");
  EXPECT_EQ(read_text_file(folder / "sweep/sweep.json"), before);
}

TEST_F(SweepTest, TheFolderNeedsNothingElseAndCanBeMoved) {
  fs::create_directory(folder / "models");
  const fs::path garment = find_asset("tshirt_1028").value();
  fs::copy(garment, folder / "models/shirt.obj");
  fs::copy(garment.parent_path() / "tshirt_1028.landmarks.toml", folder / "models/shirt.landmarks.toml");
  folder.write("worn.toml",
               "[garment]\nfile = \"models/shirt.obj\"\n[[bodies]]\nshape = \"mesh\"\nfile = \"needles\"\n");
  const Sweep sweep = planned(
      "scene = \"worn.toml\"\n[axes]\ngarment.file = [\"models/shirt.obj\", \"tshirt_5280\"]\n"
      "bodies = [[], [{ shape = \"mesh\", file = \"needles\" }]]\n");
  const std::string hash = sweep.scene_hash(1);
  fs::remove_all(folder / "models");
  fs::remove(folder / "worn.toml");
  fs::rename(folder / "sweep", folder / "moved");
  const Sweep moved = read_sweep(folder / "moved");
  EXPECT_EQ(moved.scene_hash(1), hash);
  const DrawnScene scene = moved.scene(1);
  EXPECT_TRUE(fs::exists(scene.garment.file)) << scene.garment.file;
  EXPECT_EQ(scene.garment.file.filename(), "shirt.obj");
  EXPECT_TRUE(fs::exists(scene.garment.file.parent_path() / "shirt.landmarks.toml"));
  ASSERT_EQ(scene.body_sources.size(), 1U);
  EXPECT_CONTAINS(scene.body_sources[0].file.string(), "moved/inputs/");
  EXPECT_EQ(moved.scene(2).body_sources.size(), 0U);
  EXPECT_EQ(moved.scene(0).garment.file, scene.garment.file) << "one copy of equal files";
}

TEST_F(SweepTest, ResultsOfAnotherSceneOrProgramDoNotCount) {
  Sweep sweep = planned(axes);
  ASSERT_EQ(attempt_run(sweep, 0).end, AttemptEnd::done);
  EXPECT_FALSE(attempt_run(sweep, 0).is_new);
  EXPECT_EQ(ranges_text(status_of(sweep).missing), "1-5");
  fs::copy(sweep.file(0, ".json"), sweep.file(1, ".json"));
  EXPECT_FALSE(result_of(sweep, 1)) << "it says that it is run 0";
  sweep.program = "another";
  EXPECT_FALSE(result_of(sweep, 0));
  EXPECT_EQ(status_of(sweep).missing.size(), 6U);
  EXPECT_CONTAINS(message_of<InputError>([&] { require_planned_program(sweep); }), "planned for the program another");
}

TEST_F(SweepTest, ABrokenPromiseIsAResult) {
  const Sweep sweep = planned(axes);
  const Attempt attempt = attempt_run(sweep, 3);
  EXPECT_EQ(attempt.end, AttemptEnd::broken);
  EXPECT_CONTAINS(attempt.what, "exceed solver.max_stretch = 0.05");
  const std::optional<Json> result = result_of(sweep, 3);
  ASSERT_TRUE(result);
  EXPECT_EQ((*result)["end"], "broken");
  EXPECT_EQ((*result)["where"], attempt.what);
  EXPECT_GT((*result)["max_stretch"], 0.05);
  EXPECT_EQ(status_of(sweep).broken, 1U);
  EXPECT_EQ(attempt_run(sweep, 3).end, AttemptEnd::broken) << "found again";
}

TEST_F(SweepTest, ARunThatCannotGoOnIsBroken) {
  const Sweep sweep = planned("scene = \"" TAUT_TESTS_FOLDER
                              "/contact/closing_spheres.toml\"\n[axes]\nwind.speed = "
                              "[0]\ngarment.grid.columns = [7]\ngarment.grid.rows = [7]\n");
  const Attempt attempt = attempt_run(sweep, 0);
  EXPECT_EQ(attempt.end, AttemptEnd::broken);
  EXPECT_CONTAINS(attempt.what, "something would cross");
}

TEST_F(SweepTest, WhatFailedIsSaidAndTriedAgain) {
  const Sweep sweep = planned("scene = \"scene.toml\"\n[axes]\npins.at = [[\"nowhere\"], [\"top-left\"]]\n");
  EXPECT_EQ(attempt_run(sweep, 0).end, AttemptEnd::failed);
  const SweepStatus status = status_of(sweep);
  EXPECT_EQ(status.failed, 1U);
  EXPECT_EQ(ranges_text(status.missing), "0-1");
  EXPECT_CONTAINS(status.first_failure, "run 0: ");
  EXPECT_TRUE(attempt_run(sweep, 0).is_new);
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
  EXPECT_EQ(status_of(sweep).stopped, 1U);
  double first = 0.0;
  const auto note_first = [&](double fraction) { first = first > 0.0 ? first : fraction; };
  ASSERT_EQ(attempt_run(sweep, 0, note_first).end, AttemptEnd::done);
  EXPECT_GT(first, 0.5) << "it began anew";
  EXPECT_FALSE(fs::exists(sweep.file(0, ".checkpoint")));
  const Sweep whole = planned(study, "whole");
  ASSERT_EQ(attempt_run(whole, 0).end, AttemptEnd::done);
  for (const char* name : {"state_hash", "frames", "max_stretch", "smallest_distance"}) {
    EXPECT_EQ((*result_of(sweep, 0))[name], (*result_of(whole, 0))[name]) << name;
  }
}

TEST_F(SweepTest, ADamagedCheckpointIsNotUsed) {
  const Sweep sweep = planned(axes);
  fs::create_directories(sweep.file(0, "").parent_path());
  write_text_file(sweep.file(0, ".checkpoint"), "TAUTRUN\nand then nothing");
  EXPECT_EQ(attempt_run(sweep, 0).end, AttemptEnd::done);
}

TEST_F(SweepTest, ARunThatAnotherWorksOnIsLeftAlone) {
  const Sweep sweep = planned(axes);
  fs::create_directories(sweep.file(0, "").parent_path());
  const RunLock lock(sweep.file(0, ".lock"));
  ASSERT_TRUE(lock.is_held());
  const Attempt attempt = attempt_run(sweep, 0);
  EXPECT_EQ(attempt.end, AttemptEnd::busy);
  EXPECT_CONTAINS(attempt.what, host_name());
  EXPECT_TRUE(fs::exists(sweep.file(0, ".lock")));
  EXPECT_EQ(status_of(sweep).working, 1U);
}

TEST_F(SweepTest, ALockEndsWithItsProcess) {
  const fs::path file = folder / "lock";
  {
    const RunLock lock(file);
    EXPECT_TRUE(lock.is_held());
    EXPECT_FALSE(RunLock(file).is_held());
    EXPECT_EQ(RunLock(file).owner(), lock.owner());
    EXPECT_TRUE(RunLock::is_anybodys(file));
  }
  EXPECT_FALSE(fs::exists(file));
  const pid_t child = ::fork();
  if (child == 0) {
    const RunLock lock(file);
    ::_exit(lock.is_held() ? 0 : 1);  // without removing it, as a process that is killed
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(status, 0);
  EXPECT_TRUE(fs::exists(file));
  EXPECT_FALSE(RunLock::is_anybodys(file));
  EXPECT_TRUE(RunLock(file).is_held());
  EXPECT_EQ(folder.file_count(), 1U) << "only the scene is left";
}

/// Which of some processes that try at once hold a lock, while all of them still run.
int holders_at_once(const fs::path& file, int processes) {
  std::array<int, 2> start{}, answers{}, end{};
  EXPECT_EQ(::pipe(start.data()) + ::pipe(answers.data()) + ::pipe(end.data()), 0);
  char byte = 0;
  for (int k = 0; k < processes; ++k) {
    if (::fork() == 0) {
      ::close(start[1]);
      ::close(end[1]);
      ssize_t ignored = ::read(start[0], &byte, 1);
      {
        const RunLock lock(file);
        byte = lock.is_held() ? 1 : 0;
        ignored = ::write(answers[1], &byte, 1);
        ignored = ::read(end[0], &byte, 1);
      }
      ::_exit(ignored == 0 ? 0 : 1);
    }
  }
  ::close(start[1]);
  int holders = 0;
  for (int k = 0; k < processes && ::read(answers[0], &byte, 1) == 1; ++k) {
    holders += byte;
  }
  ::close(end[1]);
  for (const int number : {start[0], answers[0], answers[1], end[0]}) {
    ::close(number);
  }
  for (int k = 0; k < processes; ++k) {
    ::wait(nullptr);
  }
  return holders;
}

TEST_F(SweepTest, OneOfManyHasALockThatWasLeftBehind) {
  const fs::path file = folder / "lock";
  for (int round = 0; round < 100; ++round) {
    write_text_file(file, "elsewhere 1");
    ASSERT_EQ(holders_at_once(file, 4), 1) << "round " << round;
  }
}

TEST_F(SweepTest, TheTableHasEveryRun) {
  const Sweep sweep = planned(axes);
  attempt_run(sweep, 1);
  const std::string table = sweep_table(sweep);
  EXPECT_CONTAINS(table, "index,solver.max_stretch,wind.speed,end,max_stretch,");
  EXPECT_CONTAINS(table, "\n0,0.6,0,missing,,");
  EXPECT_CONTAINS(table, "\n1,0.6,1.5,done,0.");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
}

TEST(Farm, RangesAreThoseOfSlurm) {
  EXPECT_EQ(ranges_text({}), "");
  EXPECT_EQ(ranges_text(std::vector<std::size_t>{3, 7, 8, 9, 12}), "3,7-9,12");
}

TEST(Farm, TheWorstEndIsTheExitCode) {
  const auto code = [](std::initializer_list<AttemptEnd> ends) {
    WorstEnd worst;
    for (const AttemptEnd end : ends) {
      worst.add(end);
    }
    return worst.exit_code();
  };
  EXPECT_EQ(code({AttemptEnd::done}), 0);
  EXPECT_EQ(code({AttemptEnd::broken, AttemptEnd::done}), 3);
  EXPECT_EQ(code({AttemptEnd::failed, AttemptEnd::broken}), 1);
  EXPECT_EQ(code({AttemptEnd::busy, AttemptEnd::failed}), 75);
}

}  // namespace
}  // namespace taut::app
