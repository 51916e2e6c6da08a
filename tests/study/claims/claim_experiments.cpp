#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

void run_stiffnesses(ClaimResults& results, const ProgressCallback& report_progress) {
  for (const double factor : stiffness_factors) {
    results.ideal_stiffnesses.push_back(
        run_method(sim::SolverKind::ideal, method_rates_hz[0], methods_duration_s, factor));
    report_progress(static_cast<double>(results.ideal_stiffnesses.size()) / stiffness_factors.size());
  }
}

// Runs a scene, which sets everything except the rigidity.
StrongRun run_strong(const std::string& garment, DrawnScene scene, bool is_rigid, int frames,
                     const ProgressCallback& report_progress) {
  SolverChoice& solver = scene.simulation.solver;
  if (is_rigid) solver.strong.rigidity = {};
  StrongRun run = {garment,
                   is_rigid,
                   solver.substeps.value_or(0),
                   solver.strong.iterations,
                   {INFINITY, INFINITY},
                   {INFINITY, INFINITY}};
  try {
    const Recording recording = record_frames(scene, std::array{frames}, report_progress);
    run.stretch = {recording.last().record.stretch.max, recording.max_stretch_seen};
    run.surface = recording.max_surface_stretch;
  } catch (const sim::Diverged&) {
    // The infinite stretch shows that the run diverged.
  }
  return run;
}

void run_strong_shirts(ClaimResults& results, const ProgressCallback& report_progress) {
  constexpr int frames = 45;
  constexpr std::array<std::array<int, 2>, 4> settings = {{{1, 10}, {1, 50}, {1, 200}, {100, 1}}};
  const DrawnScene cloth = find_scene(pinned_scenes[0], {});
  results.strong_runs.push_back(run_strong("9x9 cloth", cloth, true, cloth.frames, report_progress));
  for (const bool is_rigid : {false, true}) {
    for (const auto& [substeps, sweeps] : settings) {
      DrawnScene scene = strong_shirt_scene(model_sizes.back());
      scene.simulation.solver.substeps = substeps;
      scene.simulation.solver.strong.iterations = sweeps;
      const ProgressCallback part = report_part(report_progress, results.strong_runs.size() - 1, 2 * settings.size());
      results.strong_runs.push_back(run_strong("shirt", scene, is_rigid, frames, part));
    }
  }
}

}  // namespace

std::vector<Job> claim_experiments(ClaimResults& results) {
  std::vector<Job> jobs = {
      {"stiffnesses", 0.2, [&](const ProgressCallback& report) { run_stiffnesses(results, report); }},
      {"shirts by the paper's method", 14.0,
       [&](const ProgressCallback& report) { run_strong_shirts(results, report); }},
      {"garments of many kinds", 14.0,
       [&](const ProgressCallback& report) { results.garments = try_garments(report); }},
      {"restart", 0.05,
       [&](const ProgressCallback&) { results.restart = run_restart(find_scene(pinned_scenes[0], {}), 30, 60); }}};
  const auto add = [&](MethodTest test, double cost) {
    jobs.push_back({to_name(test), cost, [&results, test](const ProgressCallback& report) {
                      results.trials_of(test) = make_trials(test, report);
                    }});
  };
  add(MethodTest::energy, 12.0);
  add(MethodTest::rest, 22.0);
  add(MethodTest::steps, 10.0);
  return jobs;
}

RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after) {
  const DrawnScene stepped = with_steps_as_frames(scene);
  const LoadedGarment loaded = load_garment(stepped);
  const sim::Garment& garment = *loaded.garment;
  const sim::Pins pins = sim::make_pins(garment, loaded.pins);
  const sim::Surroundings surroundings = settle_surroundings(stepped.surroundings, loaded, named_bodies(stepped));
  const double time_step_s = 1.0 / stepped.simulation.frame_rate_hz;
  const auto go_on = [&](sim::State& state, int steps) {
    const auto solver = sim::make_solver(solver_settings(stepped.simulation.solver));
    for (int step = 0; step < steps; ++step) {
      std::ignore = solver->advance_frame({garment, pins, surroundings, time_step_s, throw_if_interrupted}, state);
      solver->keep_frame();
    }
  };
  sim::State state = sim::make_state(garment);
  go_on(state, steps_before);
  // The new state takes over only the positions and the length of the step between them.
  sim::State restarted = sim::make_state(garment);
  restarted.previous = state.previous;
  restarted.current = state.current;
  restarted.time_step_s = state.time_step_s;
  go_on(state, steps_after);
  go_on(restarted, steps_after);
  return {sim::hash(state), sim::hash(restarted), steps_before, steps_after};
}

TimeGrowth measure_growth(const std::vector<FrameTimes>& times, int substeps) {
  std::vector<std::array<double, 2>> points;
  for (const FrameTimes& time : times) {
    if (time.substeps == substeps) {
      // Thousands of triangles, because squares of larger numbers would lose digits.
      points.push_back({1e-3 * time.triangles, std::log(time.min_ms())});
    }
  }
  const PowerLaw power = fit_power_law(times, substeps);
  return {power.exponent, power.rms_residual, fit_line(points).rms_residual};
}

}  // namespace taut::app
