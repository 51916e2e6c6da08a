#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/models/garment_loading.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

constexpr double frame_rate_hz = 60.0;

// Consecutive frames of a method: enough to find its data in the caches again, as if it ran alone.
constexpr int frames_in_a_turn = 4;

double weight_n(const sim::Simulation& simulation) {
  const std::vector<double>& masses_kg = simulation.garment().masses_kg;
  const double mass_kg = std::accumulate(masses_kg.begin(), masses_kg.end(), 0.0);
  return -mass_kg * simulation.surroundings().forces.gravity_m_per_s2.y;
}

sim::Energy compute_energy(const sim::Simulation& simulation) {
  return sim::measure_energy(simulation.garment(), simulation.change(),
                             simulation.surroundings().forces.gravity_m_per_s2);
}

/// A trial under way.
class RunningTrial {
 public:
  RunningTrial(MethodTrial trial, const DrawnScene& scene, const GarmentInScene& cloth)
      : simulation_(make_simulation(scene, cloth)),
        start_potential_j_(compute_energy(simulation_).potential_j),
        trial_(std::move(trial)) {}

  void advance(int frames) {
    for (int frame = 0; frame < frames && !trial_.is_lost; ++frame) {
      const Stopwatch stopwatch(CLOCK_THREAD_CPUTIME_ID);
      try {
        simulation_.advance_frame(throw_if_interrupted);
      } catch (const sim::Diverged&) {
        trial_.is_lost = true;
        return;
      }
      note(stopwatch.elapsed_ms());
    }
  }

  sim::Simulation& simulation() { return simulation_; }
  MethodTrial finish() && { return std::move(trial_); }

 private:
  void note(double frame_ms) {
    const std::span<const sim::Vec3> shape = simulation_.state().current;
    const sim::Energy energy = compute_energy(simulation_);
    const double fallen_j = energy.potential_j - start_potential_j_;
    trial_.substeps = std::max(trial_.substeps, simulation_.frame_report().substeps);
    trial_.frames.push_back({simulation_.state().time_s, trial_.test == MethodTest::time ? frame_ms : NAN,
                             sim::measure_stretch(simulation_.garment().springs, shape).max,
                             sim::measure_surface_stretch(simulation_.garment(), shape).max,
                             energy.kinetic_j + fallen_j, sim::rms_speed(simulation_.change()),
                             -fallen_j / weight_n(simulation_)});
  }

  sim::Simulation simulation_;
  double start_potential_j_;
  MethodTrial trial_;
};

int frames_in(double time_s, int step_factor = 1) {
  return static_cast<int>(std::lround(time_s * frame_rate_hz / step_factor));
}

/// Returns the scene of a trial: the method with its own settings, a threshold or bound of `trial_max_stretch`, one
/// thread and no contact.
DrawnScene trial_scene(sim::SolverKind kind, int triangles) {
  DrawnScene scene =
      triangles == trial_grid_triangles ? find_scene(pinned_scenes[0], {}) : shirt_scene(shirt_scenes[0], triangles);
  scene.simulation = {};
  scene.simulation.frame_rate_hz = frame_rate_hz;
  // Cloth is never put to sleep, because the trial measures whether it comes to rest.
  scene.simulation.rest.speed_m_per_s = 0.0;
  SolverChoice& solver = scene.simulation.solver;
  solver.kind = kind;
  solver.bounded.max_stretch = trial_max_stretch;
  solver.bounded.contact = false;
  solver.bounded.threads = 1;
  return scene;
}

MethodTrials time_meshes(std::span<const int> meshes, int frames, const ProgressCallback& report_progress) {
  MethodTrials trials;
  for (const int triangles : meshes) {
    const LoadedGarment cloth = load_garment(trial_scene(sim::SolverKind::bounded, triangles));
    std::vector<RunningTrial> runs;
    for (const sim::SolverKind kind : trial_methods) {
      runs.emplace_back(MethodTrial{MethodTest::time, kind, triangles}, trial_scene(kind, triangles), cloth);
    }
    for (int done = 0; done < frames; done += frames_in_a_turn) {
      for (RunningTrial& run : runs) {
        run.advance(std::min(frames_in_a_turn, frames - done));
        report_progress(static_cast<double>(trials.size()) / static_cast<double>(meshes.size() * trial_methods.size()));
      }
    }
    for (RunningTrial& run : runs) trials.push_back(std::move(run).finish());
  }
  return trials;
}

/// Starts a trial in a scene that `change` has changed.
RunningTrial begin_trial(MethodTrial trial, const GarmentInScene& cloth,
                         const std::function<void(DrawnScene&)>& change) {
  DrawnScene scene = trial_scene(trial.kind, trial.triangles);
  change(scene);
  return {std::move(trial), scene, cloth};
}

MethodTrial drop_without_air(MethodTrial trial, const GarmentInScene& cloth, const TrialLengths& lengths) {
  RunningTrial run = begin_trial(std::move(trial), cloth, [](DrawnScene& scene) {
    sim::ExternalForces& forces = scene.surroundings.forces;
    forces.air_drag_per_s = 0.0;
    forces.wind.pressure_coefficient = forces.wind.friction_coefficient = 0.0;
  });
  run.advance(frames_in(lengths.energy_s));
  return std::move(run).finish();
}

MethodTrial shake_and_hold(MethodTrial trial, const GarmentInScene& cloth, const TrialLengths& lengths) {
  RunningTrial run = begin_trial(std::move(trial), cloth, [](DrawnScene& scene) {
    scene.surroundings.pin_motion = {{0.0, 0.0, shaken_by_m}, shaken_hz};
  });
  run.advance(frames_in(lengths.shaking_s));
  // The pins are at their start positions, and stay.
  sim::Surroundings still = run.simulation().surroundings();
  still.pin_motion = {};
  run.simulation().set_surroundings(still);
  run.advance(frames_in(lengths.rest_s));
  return std::move(run).finish();
}

/// Runs a trial with its number of time steps per frame, or with the number that the method chooses.
MethodTrial run_with_steps(MethodTrial trial, const GarmentInScene& cloth, const TrialLengths& lengths) {
  const int factor = trial.step_factor;
  const std::optional<int> substeps = trial.substeps > 0 ? std::optional(trial.substeps) : std::nullopt;
  RunningTrial run = begin_trial(std::move(trial), cloth, [&](DrawnScene& scene) {
    scene.simulation.frame_rate_hz = frame_rate_hz / factor;
    scene.simulation.solver.substeps = substeps;
  });
  run.advance(frames_in(lengths.steps_s, factor));
  return std::move(run).finish();
}

MethodTrial make_trial(MethodTrial trial, const GarmentInScene& cloth, const TrialLengths& lengths) {
  const auto& run = trial.test == MethodTest::energy ? drop_without_air
                    : trial.test == MethodTest::rest ? shake_and_hold
                                                     : run_with_steps;
  return run(std::move(trial), cloth, lengths);
}

double max_measure(const MethodTrial& trial, double TrialFrame::*measure) {
  double largest = trial.is_lost || trial.frames.empty() ? INFINITY : 0.0;
  for (const TrialFrame& frame : trial.frames) largest = std::max(largest, frame.*measure);
  return largest;
}

}  // namespace

const char* to_name(MethodTest test) {
  constexpr std::array names = {"time", "energy", "rest", "steps"};
  return names[static_cast<std::size_t>(test)];
}

double MethodTrial::max_stretch_seen() const { return max_measure(*this, &TrialFrame::stretch); }

double MethodTrial::max_surface_stretch() const { return max_measure(*this, &TrialFrame::surface_stretch); }

double MethodTrial::ranked_ms(double fraction) const {
  return quantile(collect<double>(frames, &TrialFrame::frame_ms), fraction);
}

double MethodTrial::last_speed_m_per_s() const {
  if (is_lost || frames.empty()) return INFINITY;
  double squares = 0.0, count = 0.0;
  for (const TrialFrame& frame : frames) {
    if (frame.time_s > frames.back().time_s - 0.5) {
      squares += frame.speed_m_per_s * frame.speed_m_per_s;
      count += 1.0;
    }
  }
  return std::sqrt(squares / count);
}

MethodTrials make_trials(MethodTest test, const ProgressCallback& report_progress, const TrialLengths& lengths,
                         std::span<const int> meshes) {
  if (test == MethodTest::time) return time_meshes(meshes, lengths.timed_frames, report_progress);
  const LoadedGarment cloth = load_garment(trial_scene(sim::SolverKind::bounded, trial_shirt_triangles));
  const std::size_t factors = test == MethodTest::steps ? trial_step_factors.size() : 1;
  const auto all = static_cast<double>(factors * trial_methods.size());
  MethodTrials trials;
  for (std::size_t i = 0; i < factors; ++i) {
    for (const sim::SolverKind kind : trial_methods) {
      MethodTrial trial = {test, kind, trial_shirt_triangles, trial_step_factors[i]};
      trial.substeps = i > 0 ? find_trial(trials, kind).substeps : 0;
      trials.push_back(make_trial(std::move(trial), cloth, lengths));
      report_progress(static_cast<double>(trials.size()) / all);
    }
  }
  return trials;
}

const MethodTrial& find_trial(const MethodTrials& trials, sim::SolverKind kind, int triangles, int step_factor) {
  for (const MethodTrial& trial : trials) {
    if (trial.kind == kind && trial.triangles == triangles && trial.step_factor == step_factor) return trial;
  }
  throw std::out_of_range(std::string("no trial of ") + sim::to_name(kind));
}

}  // namespace taut::app
