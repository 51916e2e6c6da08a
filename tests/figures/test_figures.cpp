#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "app/drawing/drawn_scene.hpp"
#include "app/figures/figures.hpp"
#include "app/models/garment_loading.hpp"
#include "app/runs/frame_verifier.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::SpringKind;

TEST(Figure1, ShowsTheSpringsTheMappingMade) {
  Results results;
  experiments(results).front().work([](double) {});
  const SpringPatch& grid = results.grid_patch;
  // 5x5 points: 2 * 5 * 4 edges, two diagonals in each of 16 cells, 2 * 5 * 3 springs that skip a point.
  EXPECT_EQ(grid.points_m.size(), 25U);
  EXPECT_EQ(grid.count(SpringKind::structural), 40U);
  EXPECT_EQ(grid.count(SpringKind::shear), 32U);
  EXPECT_EQ(grid.count(SpringKind::flexural), 30U);
  const SpringPatch& shirt = results.shirt_patch;
  EXPECT_GT(shirt.count(SpringKind::structural), shirt.points_m.size());
  EXPECT_EQ(shirt.count(SpringKind::shear), 0U);
  EXPECT_GT(shirt.count(SpringKind::flexural), 5U);
}

TEST(SpringPatch, OfAWholeGridHasTheMappingsCounts) {
  const sim::Garment garment = sim::make_garment(sim::make_grid({.columns = 4, .rows = 3}));
  const SpringPatch patch = whole_patch(garment);
  for (const SpringKind kind : sim::all_spring_kinds) {
    EXPECT_EQ(patch.count(kind), garment.springs.count(kind));
  }
  const SpringPatch around = patch_around(garment, 5, 1);
  EXPECT_LT(around.springs.size(), patch.springs.size());
  EXPECT_EQ(around.points_m.front(), glm::vec2(0.0F));
}

TEST(Jobs, ResultsDoNotDependOnTheNumberOfThreads) {
  const DrawnScene scene = find_scene("pinned-9x9-5", {});
  std::vector<std::uint64_t> hashes[2];
  for (const unsigned threads : {1U, 3U}) {
    std::vector<Recording> recordings(4);
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < recordings.size(); ++i) {
      jobs.push_back({"run", 1.0, [&, i](const ProgressCallback& report_progress) {
                        recordings[i] = record_frames(scene, std::array{0, 20 + static_cast<int>(i)}, report_progress);
                      }});
    }
    std::vector<std::size_t> finished;
    run_jobs(jobs, threads, [&](std::size_t job) { finished.push_back(job); });
    std::sort(finished.begin(), finished.end());
    EXPECT_EQ(finished, (std::vector<std::size_t>{0, 1, 2, 3}));
    for (const Recording& recording : recordings) {
      ASSERT_EQ(recording.moments.size(), 2U);
      hashes[threads == 1U ? 0 : 1].push_back(recording.last().record.state_hash);
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0][0], hashes[0][1]);
}

TEST(Jobs, FirstErrorStopsTheOthersAndIsThrownOn) {
  std::atomic<int> stopped = 0;
  const Job endless = {"endless", 2.0, [&](const ProgressCallback& report_progress) {
                         try {
                           while (true) {
                             report_progress(0.5);
                             std::this_thread::yield();
                           }
                         } catch (...) {
                           ++stopped;
                           throw;
                         }
                       }};
  const Job failing = {"failing", 1.0, [](const ProgressCallback&) { throw std::runtime_error("no such garment"); }};
  const std::vector<Job> jobs = {endless, failing};
  try {
    run_jobs(jobs, 2, [](std::size_t) { FAIL(); });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no such garment");
  }
  EXPECT_EQ(stopped, 1);
  // An exception while drawing stops the work as well.
  const std::vector<Job> drawn = {endless, {"short", 1.0, [](const ProgressCallback&) {}}};
  EXPECT_THROW(run_jobs(drawn, 2, [](std::size_t) { throw std::logic_error("pen broken"); }), std::logic_error);
  EXPECT_EQ(stopped, 2);
}

TEST(Recording, StepsAreTheStepsOfTheFrames) {
  DrawnScene scene = find_scene("pinned-9x9-5", {});
  scene.simulation.solver.substeps = 4;
  const std::array frames = {0, 3, 10};
  const StepRecording stepped = record_steps(scene, frames, 76, [](double) {});
  const Recording whole = record_frames(scene, frames, [](double) {});
  EXPECT_EQ(stepped.moved_m.size(), 40U);
  EXPECT_NEAR(stepped.time_step_s, 1.0 / 256.0, 1e-15);
  ASSERT_EQ(stepped.frames.moments.size(), 3U);
  EXPECT_NEAR(stepped.frames.last().record.stretch.max, whole.last().record.stretch.max, 1e-9);
  EXPECT_EQ(stepped.frames.moments[0].positions, whole.moments[0].positions);
}

TEST(Recording, LargestStretchesAreOfAllFramesThoseNotKeptIncluded) {
  const DrawnScene scene = find_scene("pinned-9x9-5", {});
  std::vector<int> all(12);
  std::iota(all.begin(), all.end(), 1);
  const auto nothing = [](double) {};
  const Recording every = record_frames(scene, all, nothing);
  double springs = 0.0, surface = 0.0, p99 = 0.0;
  for (const Moment& moment : every.moments) {
    springs = std::max(springs, moment.record.stretch.max);
    surface = std::max(surface, moment.record.surface_stretch.max);
    p99 = std::max(p99, moment.record.surface_stretch.p99);
  }
  const sim::SurfaceStretch last = every.last().record.surface_stretch;
  EXPECT_GT(surface, last.max) << "the last frame is not the one";
  EXPECT_GT(surface, springs);
  for (const Recording& one :
       {record_frames(scene, std::array{12}, nothing), record_steps(scene, std::array{12}, 76, nothing).frames}) {
    ASSERT_EQ(one.moments.size(), 1U);
    EXPECT_EQ(one.max_stretch_seen, springs);
    EXPECT_EQ(one.max_surface_stretch.max, surface);
    EXPECT_EQ(one.max_surface_stretch.p99, p99);
  }
}

TEST(Recording, CountsWhatCrossesInEveryFrameWhereAskedTo) {
  DrawnScene scene = find_scene("pinned-9x9-5", {});
  scene.simulation.solver.substeps = 1;
  // The ball begins within the cloth and is pushed out later.
  const sim::Vec3 middle_m = load_garment(scene).garment->mesh.positions[40];
  scene.bodies.push_back({.body = {.name = "ball", .shape = sim::Sphere{middle_m, 0.1}}});
  const std::array frames = {0, 5};
  EXPECT_FALSE(record_frames(scene, frames, [](double) {}).promises);
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  FrameVerifier verifier;
  PromiseCounts expected;
  for (int frame = 0; frame <= frames.back(); ++frame) {
    FrameRecord record;
    record.time_s = simulation.state().time_s;
    verifier.check(simulation, record);
    expected.crossing_pairs += *record.crossing_pairs;
    expected.max_pairs = std::max(expected.max_pairs, *record.crossing_pairs);
    expected.crossing_frames += *record.crossing_pairs > 0 ? 1 : 0;
    simulation.advance_frame();
  }
  EXPECT_GT(expected.crossing_pairs, 0U);
  for (const Recording& recording : {record_frames(
                                         scene, frames, [](double) {}, Checking::promises),
                                     record_steps(
                                         scene, frames, 40, [](double) {}, Checking::promises)
                                         .frames}) {
    ASSERT_TRUE(recording.promises);
    EXPECT_EQ(recording.promises->frames, 6);
    EXPECT_EQ(recording.promises->crossing_pairs, expected.crossing_pairs);
    EXPECT_EQ(recording.promises->max_pairs, expected.max_pairs);
    EXPECT_EQ(recording.promises->crossing_frames, expected.crossing_frames);
    EXPECT_EQ(recording.promises->stretch.springs, verifier.largest().springs);
  }
}

TEST(Recording, EndsWhereTheClothIsAtRest) {
  DrawnScene scene = find_scene("pinned-9x9-5", {});
  scene.simulation.rest.speed_m_per_s = 1e-3;
  const StepRecording fall = record_steps(scene, std::array{0, 400}, 76, [](double) {});
  EXPECT_TRUE(fall.came_to_rest);
  EXPECT_LT(fall.moved_m.size(), 300U);
  EXPECT_TRUE(fall.frames.last().record.asleep);
  EXPECT_GT(fall.moved_m.back(), 0.0) << "cloth that is put to sleep is no convergence";
}

TEST(Methods, UnrestIsThatOfTheLastQuarter) {
  MethodRun run;
  run.time_step_s = 0.5;
  run.max_stretch = {0.9, 0.9, 0.9, 0.9, 0.9, 0.9, 0.1, 0.3};
  run.moved_rms_m = {9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 3.0, 4.0};
  const auto unrest = measure_unrest(run);
  ASSERT_TRUE(unrest);
  EXPECT_NEAR(unrest->speed_m_per_s, std::sqrt(12.5) / 0.5, 1e-12);
  EXPECT_EQ(unrest->max_stretch_seen, 0.3);
  run.diverged_at_s = 1.0;
  EXPECT_FALSE(measure_unrest(run));
}

TEST(Methods, RunsAreAsLongAsAskedOrSayThatTheyDiverged) {
  const MethodRun strong = run_method(sim::SolverKind::strong, 160.0, 0.25);
  EXPECT_EQ(strong.max_stretch.size(), 40U);
  EXPECT_FALSE(strong.diverged_at_s);
  const MethodRun ideal = run_method(sim::SolverKind::ideal, 64.0, 4.0);
  ASSERT_TRUE(ideal.diverged_at_s);
  EXPECT_LT(*ideal.diverged_at_s, 4.0);
}

TEST(FrameTimes, PowerLawIsRecoveredForEachSetting) {
  std::vector<FrameTimes> times;
  for (const double n : {1000.0, 5000.0, 10000.0}) {
    const auto triangles = static_cast<int>(n);
    times.push_back({triangles, 1, 10, {1e9, 0.002 * n, 0.003 * n}});
    times.push_back({triangles, 100, 1, {n * n}});
  }
  EXPECT_NEAR(fit_power_law(times, 1).exponent, 1.0, 1e-9);
  EXPECT_NEAR(fit_power_law(times, 1).factor, 0.002, 1e-9);
  EXPECT_NEAR(fit_power_law(times, 100).exponent, 2.0, 1e-9);
  EXPECT_EQ((FrameTimes{1, 1, 1, {4.0, 1.0, 2.0, 3.0}}).median_ms(), 2.5);
}

TEST(Drawing, ScaledHasAsManyPixelsAndTheSameInIt) {
  Drawing drawing{40, 20, [](renderer::Canvas& canvas) {
                    canvas.fill_rectangle(10.0F, 0.0F, 30.0F, 10.0F, renderer::Colour{0.0F});
                  }};
  const renderer::Image twice = to_image(drawing, 2.0F);
  ASSERT_EQ(twice.width_px, 80);
  ASSERT_EQ(twice.height_px, 40);
  EXPECT_EQ(twice.at(19, 5)[0], 255);
  EXPECT_EQ(twice.at(21, 5)[0], 0);
  EXPECT_EQ(twice.at(21, 19)[0], 0);
  EXPECT_EQ(twice.at(21, 21)[0], 255);
}

}  // namespace
}  // namespace taut::app
