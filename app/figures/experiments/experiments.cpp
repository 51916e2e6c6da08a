#include "app/figures/experiments/experiments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "app/base/interruption.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/figures/experiments/moments.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/pins.hpp"
#include "sim/measures.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

void map_models(Results& results) {
  results.grid_patch = whole_patch(sim::make_garment(sim::make_grid({.columns = 5, .rows = 5})));
  const LoadedGarment loaded = load_garment(shirt_scene("tshirt-gravity", model_sizes.front()));
  const sim::Garment& shirt = *loaded.garment;
  // The middle of the chest: flat, and away from every seam.
  const sim::Vec3 chest_m(0.06, 1.25, 0.11);
  results.shirt_patch = patch_around(shirt, nearest_vertex(shirt.mesh.positions, chest_m).vertex, 2);
}

StepRecording record_fall(const ProgressCallback& report_progress) {
  DrawnScene scene = find_scene(fall_scene, {});
  scene.simulation.rest.speed_m_per_s = fall_rest_m / fall_rest_s;
  scene.simulation.rest.frames = static_cast<int>(std::lround(fall_rest_s * scene.simulation.frame_rate_hz));
  return record_steps(scene, fall_frames, followed_vertex(scene), report_progress);
}

void run_methods(Results& results, const ProgressCallback& report_progress) {
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) {
      results.methods.push_back(run_method(kind, rate_hz, methods_duration_s));
      report_progress(static_cast<double>(results.methods.size()) / 6.0);
    }
  }
}

void run_stiffnesses(Results& results, const ProgressCallback& report_progress) {
  for (const double factor : stiffness_factors) {
    results.ideal_stiffnesses.push_back(
        run_method(sim::SolverKind::ideal, method_rates_hz[0], methods_duration_s, factor));
    report_progress(static_cast<double>(results.ideal_stiffnesses.size()) / stiffness_factors.size());
  }
}

// The scene asks for everything but what is varied.
StrongRun run_strong(const std::string& garment, DrawnScene scene, bool is_rigid, int frames,
                     const ProgressCallback& report_progress) {
  SolverChoice& solver = scene.simulation.solver;
  if (is_rigid) {
    solver.strong.rigidity = {};
  }
  StrongRun run = {garment,
                   is_rigid,
                   solver.substeps.value_or(0),
                   solver.strong.iterations,
                   {INFINITY, INFINITY},
                   {INFINITY, INFINITY}};
  try {
    const Recording recording = record_frames(scene, std::array{frames}, report_progress);
    run.stretch = {recording.last().record.stretch.max, recording.largest_stretch};
    run.surface = recording.largest_surface_stretch;
  } catch (const sim::Diverged&) {
    // Infinite stretch says so.
  }
  return run;
}

void run_strong_shirts(Results& results, const ProgressCallback& report_progress) {
  constexpr int frames = 45;
  constexpr std::array<std::array<int, 2>, 4> settings = {{{1, 10}, {1, 50}, {1, 200}, {100, 1}}};
  const DrawnScene cloth = find_scene(pinned_scenes[0], {});
  results.strong_runs.push_back(run_strong("9x9 cloth", cloth, true, cloth.frames, report_progress));
  for (const bool is_rigid : {false, true}) {
    for (const auto& [substeps, sweeps] : settings) {
      DrawnScene scene = strong_shirt_scene(model_sizes.back());
      scene.simulation.solver.substeps = substeps;
      scene.simulation.solver.strong.iterations = sweeps;
      const auto before = static_cast<double>(results.strong_runs.size() - 1);
      results.strong_runs.push_back(run_strong("shirt", scene, is_rigid, frames, [&](double fraction) {
        report_progress((before + fraction) / (2.0 * settings.size()));
      }));
    }
  }
}

Job recording_job(const std::string& scene_name, double cost, std::optional<Recording>& place) {
  return {scene_name, cost, [scene_name, &place](const ProgressCallback& report_progress) {
            const DrawnScene scene = find_scene(scene_name, {});
            place = record_frames(scene, std::array{scene.frames}, report_progress, Checking::promises);
          }};
}

Job trials_job(MethodTest test, double cost, Results& results) {
  return {std::string("methods: ") + name_of(test), cost,
          [test, &results](const ProgressCallback& report_progress) {
            results.trials_of(test) = make_trials(test, report_progress);
          }};
}

void record_strong_wind(Results& results, const ProgressCallback& report_progress) {
  std::vector<int> frames(strong_wind_frames - film_first_frame + 1);
  std::iota(frames.begin(), frames.end(), film_first_frame);
  results.film = record_frames(find_scene(shirt_scenes[2], {}), frames, report_progress, Checking::promises);
  results.shirts[2] = results.film;
  results.shirts[2]->moments = {results.film->last()};
}

}  // namespace

Job job_of(Experiment experiment, Results& results) {
  switch (experiment) {
    case Experiment::mapping:
      return {"mapping", 0.1, [&results](const ProgressCallback&) { map_models(results); }};
    case Experiment::fall:
      return {fall_scene, 10.0, [&results](const ProgressCallback& report_progress) {
                results.fall = record_fall(report_progress);
              }};
    case Experiment::pinned_5:
      return recording_job(pinned_scenes[0], 0.1, results.pinned[0]);
    case Experiment::pinned_20:
      return recording_job(pinned_scenes[1], 0.1, results.pinned[1]);
    case Experiment::shirt_still:
      return recording_job(shirt_scenes[0], 16.0, results.shirts[0]);
    case Experiment::shirt_wind_1:
      return recording_job(shirt_scenes[1], 16.0, results.shirts[1]);
    case Experiment::shirt_wind_10:
      return {shirt_scenes[2], 26.0, [&results](const ProgressCallback& report_progress) {
                record_strong_wind(results, report_progress);
              }};
    case Experiment::methods:
      return {"methods", 0.3,
              [&results](const ProgressCallback& report_progress) { run_methods(results, report_progress); }};
    case Experiment::methods_energy:
      return trials_job(MethodTest::energy, 12.0, results);
    case Experiment::methods_rest:
      return trials_job(MethodTest::rest, 22.0, results);
    case Experiment::methods_steps:
      return trials_job(MethodTest::steps, 10.0, results);
    case Experiment::stiffnesses:
      return {"stiffnesses", 0.2, [&results](const ProgressCallback& report_progress) {
                run_stiffnesses(results, report_progress);
              }};
    case Experiment::strong_runs:
      return {"shirts by the paper's method", 14.0, [&results](const ProgressCallback& report_progress) {
                run_strong_shirts(results, report_progress);
              }};
    case Experiment::garments:
      return {"garments of many kinds", 14.0, [&results](const ProgressCallback& report_progress) {
                results.garments = try_garments(report_progress);
              }};
    case Experiment::restart:
      return {"restart", 0.05, [&results](const ProgressCallback&) {
                results.restart = run_restart(find_scene("pinned-9x9-5", {}), 30, 60);
              }};
  }
  return {};
}

sim::Index followed_vertex(const DrawnScene& scene) {
  const sim::GridSettings& grid = scene.garment.grid;
  return (grid.rows - 1) * grid.columns + grid.columns / 2;
}

DrawnScene shirt_scene(const std::string& name, int triangles) {
  DrawnScene scene = find_scene(name, {});
  scene.garment.file = scene.garment.file.parent_path() / fmt::format("tshirt_{}.obj", triangles);
  return scene;
}

DrawnScene strong_shirt_scene(int triangles) {
  DrawnScene scene = shirt_scene("tshirt-gravity", triangles);
  scene.simulation.solver.kind = sim::SolverKind::strong;
  // Rigid against compression too, triangles lock and the shirt does not fall into folds.
  scene.simulation.solver.strong.rigidity = {0.1, 0.01};
  return scene;
}

MethodRun run_method(sim::SolverKind kind, double steps_per_s, double duration_s, double stiffness_factor) {
  DrawnScene scene = find_scene("pinned-9x9-methods", {});
  scene.simulation.solver.kind = kind;
  scene.simulation.frame_rate_hz = steps_per_s;
  scene.simulation.solver.ideal.stiffness.structural_n_per_m *= stiffness_factor;
  scene.simulation.solver.ideal.stiffness.shear_n_per_m *= stiffness_factor;
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  MethodRun run;
  run.kind = kind;
  run.time_step_s = simulation.frame_time_s();
  run.stiffness_n_per_m = scene.simulation.solver.ideal.stiffness.structural_n_per_m;
  const auto steps = static_cast<int>(std::lround(duration_s * steps_per_s));
  try {
    for (int step = 0; step < steps; ++step) {
      simulation.advance_frame(throw_if_interrupted);
      const sim::ShapeChange change = simulation.change();
      run.max_stretch.push_back(sim::measure_stretch(simulation.garment().springs, change.now).max);
      run.moved_rms_m.push_back(sim::measure_convergence(change).rms_m);
    }
  } catch (const sim::Diverged&) {
    run.diverged_at_s = run.time_step_s * static_cast<double>(run.max_stretch.size() + 1);
  }
  return run;
}

std::optional<Unrest> measure_unrest(const MethodRun& run) {
  if (run.diverged_at_s || run.moved_rms_m.empty()) {
    return std::nullopt;
  }
  const std::size_t begin = run.moved_rms_m.size() - (run.moved_rms_m.size() + 3) / 4;
  double squares = 0.0;
  for (std::size_t i = begin; i < run.moved_rms_m.size(); ++i) {
    squares += run.moved_rms_m[i] * run.moved_rms_m[i];
  }
  const auto [low, high] = std::minmax_element(run.max_stretch.begin() + static_cast<std::ptrdiff_t>(begin),
                                               run.max_stretch.end());
  const auto count = static_cast<double>(run.moved_rms_m.size() - begin);
  return Unrest{std::sqrt(squares / count) / run.time_step_s, *low, *high};
}

RestartRun run_restart(const DrawnScene& scene, int steps_before, int steps_after) {
  const DrawnScene stepped = with_steps_as_frames(scene);
  const LoadedGarment loaded = load_garment(stepped);
  const sim::Garment& garment = *loaded.garment;
  const sim::Pins pins = sim::make_pins(garment, loaded.pins);
  const sim::Surroundings surroundings = settled(stepped.surroundings, loaded);
  const double time_step_s = 1.0 / stepped.simulation.frame_rate_hz;
  const auto go_on = [&](sim::State& state, int steps) {
    const auto solver = sim::make_solver(solver_settings(stepped.simulation.solver));
    for (int step = 0; step < steps; ++step) {
      std::ignore =
          solver->advance_frame({garment, pins, surroundings, time_step_s, throw_if_interrupted}, state);
      solver->keep_frame();
    }
  };
  sim::State state = sim::make_state(garment);
  go_on(state, steps_before);
  // Nothing but positions goes over, and the length of the step that lies between them.
  sim::State restarted = sim::make_state(garment);
  restarted.previous = state.previous;
  restarted.current = state.current;
  restarted.time_step_s = state.time_step_s;
  go_on(state, steps_after);
  go_on(restarted, steps_after);
  return {sim::hash(state), sim::hash(restarted), steps_before, steps_after};
}

}  // namespace taut::app
