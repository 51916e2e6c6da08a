#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "smallest_print.hpp"
#include "study/claims/made_trials.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::TemporaryFolder;

TEST(Figure8, TableHasARowForEveryFrameAndForWhatWasLost) {
  ClaimResults results;
  results.trials_of(MethodTest::steps) = {
      {MethodTest::steps, sim::SolverKind::ideal, 1028, 5, 20, true, {{0.5, NAN, 0.25, 0.5, -1, 2, 0.125}}}};
  EXPECT_EQ(figure8_csv(results),
            "test,triangles,method,step_factor,substeps,time_s,frame_ms,max_stretch,max_surface_stretch,"
            "energy_j,rms_speed_m_per_s,sunk_m\nsteps,1028,ideal,5,20,0.5,,0.25,0.5,-1,2,0.125\n"
            "steps,1028,ideal,5,20,,,,,,,\n");
}

// Results with two lost trials: one after a frame, one before its first.
ClaimResults results_with_losses() {
  ClaimResults results;
  test::make_up_trials(results);
  for (const int factor : {2, 5}) {
    MethodTrial& lost =
        test::trial_in(results, MethodTest::steps, sim::SolverKind::ideal, trial_shirt_triangles, factor);
    lost.is_lost = true;
    lost.frames.resize(factor == 2 ? 1 : 0);
  }
  return results;
}

TEST(Figure8, ReadBackItGivesTheSameTable) {
  const TemporaryFolder folder;
  const ClaimResults results = results_with_losses();
  write_text_file(folder / "fig8.csv", figure8_csv(results));
  ClaimResults again;
  read_figure8(again, folder / "");
  EXPECT_TRUE(figure8_csv(again) == figure8_csv(results));
  const MethodTrials& steps = again.trials_of(MethodTest::steps);
  EXPECT_TRUE(find_trial(steps, sim::SolverKind::ideal, trial_shirt_triangles, 5).is_lost);
  EXPECT_FALSE(find_trial(steps, sim::SolverKind::provot, trial_shirt_triangles, 5).is_lost);
}

TEST(Figure8, TextsAreLargeEnoughInPrint) {
  ClaimResults results = results_with_losses();
  LazyOffscreenRenderer offscreen("auto", 0.02F);
  EXPECT_GE(test::smallest_print_pt(make_figure8(results).draw(offscreen)), test::min_text_pt);
}

TEST(Restart, PositionsAloneGoOnToTheSameBits) {
  const RestartRun run = run_restart(find_scene("pinned-9x9-5", {}), 10, 10);
  EXPECT_EQ(run.uninterrupted_hash, run.restarted_hash);
  EXPECT_NE(run.uninterrupted_hash, run_restart(find_scene("pinned-9x9-5", {}), 10, 11).uninterrupted_hash);
}

TEST(Figure8, WhatIsWrongWithTrialsIsSaid) {
  const TemporaryFolder folder;
  ClaimResults results;
  test::make_up_trials(results);
  const std::string table = figure8_csv(results);
  const auto error_with = [&](const std::string& text) {
    folder.write("fig8.csv", text);
    ClaimResults read;
    const std::string error = test::error_message<InputError>([&] { read_figure8(read, folder / ""); });
    return error.substr(error.find("fig8.csv") == std::string::npos ? 0 : error.find("fig8.csv"));
  };
  const std::string head = table.substr(0, table.find('\n') + 1);
  EXPECT_EQ(error_with(head + "time,128,magic,1,20,1,1,1,1,1,1,1\n"),
            "fig8.csv:2: method: found 'magic', expected one of ideal, provot, implicit, vassilev, "
            "fast-projection, strong, bounded");
  EXPECT_EQ(error_with(head + "fly,128,ideal,1,20,1,1,1,1,1,1,1\n"),
            "fig8.csv:2: test: found 'fly', expected one of time, energy, rest, steps");
  EXPECT_EQ(error_with(table.substr(0, table.find("\nsteps,") + 1)),
            "fig8.csv: found 0 trials of the test steps, expected 21");
}

}  // namespace
}  // namespace taut::app
