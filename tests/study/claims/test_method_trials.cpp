#include <gtest/gtest.h>

#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

using enum sim::SolverKind;

const auto nothing = [](double) {};

TEST(MethodTrials, TimeFramesOfAllMethodsAndStretchThemAlikeEachTime) {
  const std::array meshes = {trial_grid_triangles};
  const TrialLengths lengths = {.timed_frames = 6};
  const MethodTrials trials = make_trials(MethodTest::time, nothing, lengths, meshes);
  const MethodTrials again = make_trials(MethodTest::time, nothing, lengths, meshes);
  ASSERT_EQ(trials.size(), trial_methods.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(trials[i].kind, trial_methods[i]);
    ASSERT_EQ(trials[i].frames.size(), 6U) << "one turn and a part of the next";
    EXPECT_GT(trials[i].ranked_ms(0.5), 0.0);
    EXPECT_GT(trials[i].substeps, 0);
    EXPECT_EQ(trials[i].max_stretch_seen(), again[i].max_stretch_seen());
    EXPECT_EQ(trials[i].frames.back().energy_j, again[i].frames.back().energy_j);
    EXPECT_EQ(trials[i].frames.back().speed_m_per_s, again[i].frames.back().speed_m_per_s);
  }
  EXPECT_LE(find_trial(trials, bounded, trial_grid_triangles).max_surface_stretch(), trial_max_stretch);
  EXPECT_LT(find_trial(trials, provot, trial_grid_triangles).max_stretch_seen(),
            0.7 * find_trial(trials, ideal, trial_grid_triangles).max_stretch_seen())
      << "all thresholds are as low";
  EXPECT_THROW(find_trial(trials, bounded, trial_shirt_triangles), std::out_of_range);
}

// Returns trials of all methods on the coarse shirt, run once for several tests.
const MethodTrials& with_longer_steps() {
  static const MethodTrials trials = make_trials(MethodTest::steps, nothing, {.steps_s = 1.0 / 12.0});
  return trials;
}

TEST(MethodTrials, LongerStepsAreAsManyInLongerFrames) {
  for (const int factor : trial_step_factors) {
    const MethodTrial& trial = find_trial(with_longer_steps(), bounded, trial_shirt_triangles, factor);
    ASSERT_EQ(trial.frames.size(), static_cast<std::size_t>(std::lround(5.0 / factor)));
    EXPECT_NEAR(trial.frames.front().time_s, factor / 60.0, 1e-12);
    EXPECT_EQ(trial.substeps, find_trial(with_longer_steps(), bounded).substeps);
    EXPECT_LE(trial.max_surface_stretch(), trial_max_stretch);
    EXPECT_TRUE(std::isnan(trial.frames.front().frame_ms)) << "other experiments run beside it";
  }
  const MethodTrial& lost = find_trial(with_longer_steps(), ideal, trial_shirt_triangles, 5);
  EXPECT_TRUE(lost.is_lost);
  EXPECT_EQ(lost.max_stretch_seen(), INFINITY);
  EXPECT_EQ(lost.last_speed_m_per_s(), INFINITY);
}

TEST(MethodTrials, LoseEnergyToAirInAirAlone) {
  const MethodTrials without = make_trials(MethodTest::energy, nothing, {.energy_s = 2.0 / 60.0});
  for (const sim::SolverKind kind : trial_methods) {
    const TrialFrame& slowed = find_trial(with_longer_steps(), kind).frames[1];
    const TrialFrame& free = find_trial(without, kind).frames[1];
    // Drag takes a fortieth of the speed in two frames, pressure a tenth of that.
    EXPECT_GT(free.speed_m_per_s, (kind == bounded ? 1.0255 : 1.02) * slowed.speed_m_per_s) << sim::to_name(kind);
    EXPECT_LT(free.energy_j, 0.0) << sim::to_name(kind);
  }
}

TEST(MethodTrials, AreShakenAndThenHeld) {
  const MethodTrials shaken =
      make_trials(MethodTest::rest, nothing, {.shaking_s = 0.5 / shaken_hz, .rest_s = 1.0 / 60.0});
  for (const sim::SolverKind kind : trial_methods) {
    const std::vector<TrialFrame>& frames = find_trial(shaken, kind).frames;
    ASSERT_EQ(frames.size(), 11U);
    EXPECT_GT(frames[4].speed_m_per_s, 1.15 * find_trial(with_longer_steps(), kind).frames[4].speed_m_per_s);
    EXPECT_LT(frames[10].speed_m_per_s, frames[9].speed_m_per_s) << sim::to_name(kind);
  }
}

TEST(MethodTrials, EndAtTheSpeedOfTheirLastHalfSecond) {
  MethodTrial trial;
  for (const auto& [time_s, speed_m_per_s] : {std::pair(0.4, 9.0), {1.0, 3.0}, {1.25, 4.0}}) {
    trial.frames.push_back({time_s, NAN, 0.1, 0.2, 0.0, speed_m_per_s, 0.0});
  }
  EXPECT_NEAR(trial.last_speed_m_per_s(), std::sqrt(12.5), 1e-12);
}

}  // namespace
}  // namespace taut::app
