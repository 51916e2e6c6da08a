#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/figures/csv.hpp"
#include "app/figures/figures.hpp"
#include "app/figures/moment_tables.hpp"
#include "app/figures/print.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::SpringKind;
using test::TemporaryFolder;

TEST(Figure1, ShowsTheSpringsTheMappingMade) {
  Results results;
  job_of(Experiment::mapping, results).work([](double) {});
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
      jobs.push_back(
          {"run", 1.0, [&, i](const ProgressCallback& report_progress) {
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
  const Job failing = {"failing", 1.0,
                       [](const ProgressCallback&) { throw std::runtime_error("no such garment"); }};
  const std::vector<Job> jobs = {endless, failing};
  try {
    run_jobs(jobs, 2, [](std::size_t) { FAIL(); });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no such garment");
  }
  EXPECT_EQ(stopped, 1);
  // What is thrown while drawing stops the work as well.
  const std::vector<Job> drawn = {endless, {"short", 1.0, [](const ProgressCallback&) {}}};
  EXPECT_THROW(run_jobs(drawn, 2, [](std::size_t) { throw std::logic_error("pen broken"); }),
               std::logic_error);
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
    surface = std::max(surface, surface_stretch_of(every, moment).max);
    p99 = std::max(p99, surface_stretch_of(every, moment).p99);
  }
  const sim::SurfaceStretch last = surface_stretch_of(every, every.last());
  EXPECT_GT(surface, last.max) << "the last frame is not the one";
  EXPECT_GT(surface, springs);
  for (const Recording& one : {record_frames(scene, std::array{12}, nothing),
                               record_steps(scene, std::array{12}, 76, nothing).frames}) {
    ASSERT_EQ(one.moments.size(), 1U);
    EXPECT_EQ(one.largest_stretch, springs);
    EXPECT_EQ(one.largest_surface_stretch.max, surface);
    EXPECT_EQ(one.largest_surface_stretch.p99, p99);
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

TEST(Restart, PositionsAloneGoOnToTheSameBits) {
  const RestartRun run = run_restart(find_scene("pinned-9x9-5", {}), 10, 10);
  EXPECT_EQ(run.uninterrupted_hash, run.restarted_hash);
  EXPECT_NE(run.uninterrupted_hash, run_restart(find_scene("pinned-9x9-5", {}), 10, 11).uninterrupted_hash);
}

TEST(Methods, UnrestIsThatOfTheLastQuarter) {
  MethodRun run;
  run.time_step_s = 0.5;
  run.max_stretch = {0.9, 0.9, 0.9, 0.9, 0.9, 0.9, 0.1, 0.3};
  run.moved_rms_m = {9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 3.0, 4.0};
  const auto unrest = measure_unrest(run);
  ASSERT_TRUE(unrest);
  EXPECT_NEAR(unrest->speed_m_per_s, std::sqrt(12.5) / 0.5, 1e-12);
  EXPECT_EQ(unrest->smallest_stretch, 0.1);
  EXPECT_EQ(unrest->largest_stretch, 0.3);
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

TEST(FigureTables, HaveTheirColumnsAndARowForEveryMeasurement) {
  Results results;
  results.fall.emplace();
  results.fall->time_step_s = 0.5;
  results.fall->moved_m = {0.25, 0.125};
  EXPECT_EQ(figure3_csv(results), "iteration,time_s,moved_m\n1,0.5,0.25\n2,1,0.125\n");
  results.frame_times = {{1028, 1, 10, {1.5, 2.5}}};
  EXPECT_EQ(figure6_csv(results),
            "triangles,substeps,sweeps,repeat,frame_ms\n1028,1,10,1,1.5\n1028,1,10,2,2.5\n");
  results.methods = {{sim::SolverKind::provot, 0.5, {0.125}, {0.25}, {}}};
  EXPECT_EQ(figure7_csv(results),
            "method,time_step_s,time_s,max_stretch,moved_rms_m\nprovot,0.5,0.5,0.125,0.25\n");
}

Results small_results() {
  Results results;
  const auto nothing = [](double) {};
  for (std::size_t i = 0; i < results.pinned.size(); ++i) {
    results.pinned[i] = record_frames(find_scene(pinned_scenes[i], {}), std::array{0, 7}, nothing);
  }
  results.fall = record_steps(find_scene(fall_scene, {}), std::array{0, 2}, 5, nothing);
  results.frame_times = {{1028, 1, 10, {1.5, 2.5}}, {5280, 1, 10, {3.0}}, {1028, 100, 1, {0.1}}};
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) {
      results.methods.push_back(run_method(kind, rate_hz, 0.1));
    }
  }
  return results;
}

TEST(FigureTables, ReadBackTheyGiveTheSameTables) {
  const TemporaryFolder folder;
  const Results results = small_results();
  Results again;
  for (const Figure& figure : all_figures()) {
    if (figure.read == nullptr || figure.name == "fig5") {
      continue;
    }
    write_text_file(folder / (figure.name + ".csv"), figure.csv(results));
    if (figure.shapes_csv != nullptr) {
      write_text_file(folder / (figure.name + "_shapes.csv"), figure.shapes_csv(results));
    }
    figure.read(folder / "", again);
    EXPECT_TRUE(figure.csv(again) == figure.csv(results)) << figure.name;
    if (figure.shapes_csv != nullptr) {
      EXPECT_TRUE(figure.shapes_csv(again) == figure.shapes_csv(results)) << figure.name;
    }
  }
  EXPECT_TRUE(again.fall->came_to_rest) << "a run that ends before its last frame";
  EXPECT_EQ(again.fall->vertex, followed_vertex(again.fall->frames.scene));
  EXPECT_TRUE(again.methods[0].diverged_at_s) << "a run that ends before its last step";
}

// Along the diagonal of its cells a fifth longer, across it as at rest: edges grow by less than the surface.
Recording recording_of_a_diagonal_stretch() {
  Recording recording;
  recording.scene.name = "diagonal";
  recording.garment = sim::share(sim::make_garment(sim::make_grid({.columns = 3, .rows = 3})));
  recording.moments.resize(1);
  for (const sim::Vec3& p : recording.garment->mesh.positions) {
    const double along = 0.5 * (p.x + p.y);
    recording.moments[0].positions.push_back(p + 0.2 * sim::Vec3(along, along, 0.0));
  }
  recording.moments[0].record.stretch =
      sim::measure_stretch(recording.garment->springs, recording.moments[0].positions);
  return recording;
}

TEST(FigureTables, HaveTheStretchOfSpringsAndOfTheSurface) {
  const TemporaryFolder folder;
  const Recording recording = recording_of_a_diagonal_stretch();
  write_text_file(folder / "moments.csv", moments_csv(std::array{&recording}));
  const CsvFile table(folder / "moments.csv",
                      {"panel", "scene", "frame", "time_s", "at_rest", "max_stretch", "p99_stretch",
                       "max_surface_stretch", "p99_surface_stretch", "mean_stretch"});
  const double edge = std::sqrt(0.5 * (1.2 * 1.2 + 1.0)) - 1.0;
  for (const auto& [column, expected] : {std::pair(5U, edge), {6U, edge}, {7U, 0.2}, {8U, 0.2}, {9U, edge}}) {
    EXPECT_NEAR(table.number(0, column), expected, 1e-12) << column;
  }
}

TEST(FigureCaptions, SayTheStretchOfSpringsAndOfTheSurface) {
  const Recording recording = recording_of_a_diagonal_stretch();
  EXPECT_EQ(largest_stretch_text({&recording, &recording.last()}),
            "largest stretch: springs 10.45 %, surface 20 %");
}

TEST(FigureTables, WhatIsWrongWithOneIsSaidWithItsLine) {
  const TemporaryFolder folder;
  const std::string head =
      "panel,scene,frame,time_s,at_rest,max_stretch,p99_stretch,max_surface_stretch,p99_surface_stretch,mean_"
      "stretch\n";
  const std::string shapes = "panel,vertex,x_m,y_m,z_m\n";
  const auto error_with = [&](const std::string& moments, const std::string& positions) {
    folder.write("fig4.csv", moments);
    folder.write("fig4_shapes.csv", positions);
    Results results;
    const std::string error = test::message_of<InputError>([&] { read_figure4(folder / "", results); });
    return error.substr(error.find("fig4") == std::string::npos ? 0 : error.find("fig4"));
  };
  const std::string row = "a,pinned-9x9-5,1,0.1,0,0,0,0,0,0\n";
  EXPECT_EQ(error_with("a,b\n1,2\n", shapes).substr(0, 37), "fig4.csv:1: found the columns a,b, ex");
  EXPECT_EQ(error_with(head + "a,b\n", shapes), "fig4.csv:2: found 2 cells, expected 10");
  EXPECT_EQ(error_with(head, shapes), "fig4.csv: found no rows, expected at least one");
  EXPECT_EQ(error_with(head + "a,\"x, y\",1,0.1,0,0,0,0,0,0\n", shapes + "a,0,0,0,0\n"),
            "fig4.csv: found no moment of the scene pinned-9x9-5, expected one");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,0,0\na,2,0,0,0\n"),
            "fig4_shapes.csv:3: panel a: found vertex 2, expected 1");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,up,0\n"),
            "fig4_shapes.csv:2: y_m: found 'up', expected a number");
  EXPECT_EQ(error_with(head + "a,pinned-9x9-5,1.5,0.1,0,0,0,0,0,0\n", shapes + "a,0,0,0,0\n"),
            "fig4.csv:2: frame: found '1.5', expected a whole number");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,0,0\n"),
            "fig4_shapes.csv: panel a: found 1 vertices, expected 81, as the garment of pinned-9x9-5 has");
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
