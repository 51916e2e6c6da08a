#pragma once

#include "tests/study/claims/trials.hpp"

namespace taut::test {

/// Returns a trial of the results, as find_trial() does, for a test to change.
inline app::MethodTrial& trial_in(app::ClaimResults& results, app::MethodTest test, sim::SolverKind kind,
                                  int triangles = app::trial_shirt_triangles, int step_factor = 1) {
  return const_cast<app::MethodTrial&>(app::find_trial(results.trials_of(test), kind, triangles, step_factor));
}

/// Fills the trials of figure 8 with two frames each, for which every claim about them holds.
inline void make_up_trials(app::ClaimResults& results) {
  using enum sim::SolverKind;
  const auto add = [&](app::MethodTest test, int triangles, int step_factor) {
    for (const sim::SolverKind kind : app::trial_methods) {
      const double frame_ms = kind == strong ? 1.0 : kind == implicit ? 2.0 : 10.0;
      const double stretch = kind == strong ? 0.01 : kind == ideal || kind == vassilev || kind == implicit ? 0.1 : 0.02;
      const double speed_m_per_s = kind == vassilev ? 0.1 : 0.001;
      app::MethodTrial trial = {test, kind, triangles, step_factor, 20, false, {}};
      for (const double time_s : {0.1, 0.2}) {
        trial.frames.push_back({time_s, test == app::MethodTest::time ? frame_ms : NAN, stretch, 2.0 * stretch,
                                -0.01 * time_s, speed_m_per_s, 0.01});
      }
      results.trials_of(test).push_back(trial);
    }
  };
  for (const int triangles : app::trial_meshes) add(app::MethodTest::time, triangles, 1);
  add(app::MethodTest::energy, app::trial_shirt_triangles, 1);
  add(app::MethodTest::rest, app::trial_shirt_triangles, 1);
  for (const int factor : app::trial_step_factors) add(app::MethodTest::steps, app::trial_shirt_triangles, factor);
}

}  // namespace taut::test
