#include "app/base/interruption.hpp"
#include "app/base/ranks.hpp"
#include "app/base/stopwatch.hpp"
#include "app/base/words.hpp"
#include "app/figures/experiments/experiments.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {
namespace {

struct Sample {
  const char* file;
  const char* kind;
};

// One of every kind, each in one format, about 1 m large.
constexpr std::array samples = {
    Sample{"sheet.obj", "an open sheet of quads"},
    Sample{"irregular.ply", "irregular triangles"},
    Sample{"graded.off", "triangles from 6 cm down to 2 mm"},
    Sample{"skirt.stl", "a tube of unconnected triangles"},
    Sample{"turned.obj", "triangles that face both ways"},
    Sample{"cushion.dae", "closed, without a border"},
    Sample{"sleeves.dae", "three parts that are not joined"},
    Sample{"lining.fbx", "two layers"},
    Sample{"wings.ply", "three sheets at one edge, non-manifold"},
    Sample{"band.stl", "a Möbius band, one-sided"},
    Sample{"honeycomb.obj", "hexagons"},
};

Mapping mapping_of(const sim::Garment& garment) {
  const auto springs_of = sim::edges_of_vertices(garment.mesh.positions.size(), garment.springs.ends);
  Mapping mapping;
  mapping.vertices = garment.mesh.positions.size();
  mapping.triangles = garment.mesh.triangles.size();
  mapping.edges = garment.adjacency.edges.size();
  mapping.structural = garment.springs.count(sim::SpringKind::structural);
  mapping.flexural = garment.springs.count(sim::SpringKind::flexural);
  for (std::size_t v = 0; v < springs_of.size(); ++v) mapping.loose_vertices += springs_of[v].empty() ? 1 : 0;
  return mapping;
}

TrialRun run_trial(const LoadedGarment& loaded, const DrawnScene& scene, const ProgressCallback& report_progress) {
  sim::Simulation simulation = make_simulation(scene, loaded);
  FrameOutputs outputs;
  outputs.report = [&](const FrameRecord& record) {
    report_progress(static_cast<double>(record.frame) / trial_frames);
  };
  try {
    std::vector<double> times_ms;
    TrialRun run;
    for (const FrameRecord& record : run_frames(simulation, trial_frames, outputs)) {
      run.largest_stretch = std::max(run.largest_stretch, record.stretch.max);
      times_ms.push_back(record.sim_ms);
    }
    run.median_ms = median(times_ms);
    return run;
  } catch (const sim::Diverged&) {
    return {INFINITY, 0.0};
  }
}

struct StepSettings {
  int substeps;
  int sweeps;
};

// {substeps, sweeps}: one long step with several sweeps, and many short steps with one sweep. The second
// stretches far less.
constexpr std::array<StepSettings, 2> measured_settings = {{{1, 10}, {100, 1}}};

struct TimedRun {
  sim::Simulation simulation;
  FrameTimes times;
};

TimedRun make_timed_run(int triangles, DrawnScene scene) {
  // The method alone: contact is another matter.
  scene.simulation.solver.bounded.contact = false;
  const bool is_strong = scene.simulation.solver.kind == sim::SolverKind::strong;
  FrameTimes times;
  times.triangles = triangles;
  times.substeps = is_strong ? scene.simulation.solver.substeps.value_or(0) : 0;
  times.sweeps = is_strong ? scene.simulation.solver.strong.iterations : 0;
  return {make_simulation(scene, load_garment(scene)), times};
}

std::vector<TimedRun> make_timed_runs() {
  std::vector<TimedRun> runs;
  for (const StepSettings& settings : measured_settings) {
    for (const int triangles : model_sizes) {
      DrawnScene scene = strong_shirt_scene(triangles);
      scene.simulation.solver.substeps = settings.substeps;
      scene.simulation.solver.strong.iterations = settings.sweeps;
      runs.push_back(make_timed_run(triangles, std::move(scene)));
    }
  }
  for (const int triangles : model_sizes) {
    runs.push_back(make_timed_run(triangles, shirt_scene(shirt_scenes[0], triangles)));
  }
  return runs;
}

void time_frame(TimedRun& run) {
  const ProcessorStopwatch stopwatch;
  run.simulation.advance_frame(throw_if_interrupted);
  run.times.frame_ms.push_back(stopwatch.elapsed_ms());
  const double stretch = sim::measure_stretch(run.simulation.garment().springs, run.simulation.state().current).max;
  run.times.largest_stretch = std::max(run.times.largest_stretch, stretch);
}

}  // namespace

GarmentTrial try_garment(const std::string& file, const std::string& kind, const ProgressCallback& report_progress) {
  GarmentTrial trial;
  trial.file = std::filesystem::path(file).filename().string();
  trial.kind = kind;
  try {
    DrawnScene scene = find_scene(file, {});
    scene.garment.mesh = MeshChoice::model;  // which springs each kind of model gives
    const LoadedGarment loaded = load_garment(scene);
    trial.mapping = mapping_of(*loaded.garment);
    SolverChoice& solver = scene.simulation.solver;
    solver = {};
    solver.kind = sim::SolverKind::strong;
    solver.substeps = trial_steps;
    solver.strong.iterations = trial_sweeps;
    trial.strong = run_trial(loaded, scene, [&](double done) { report_progress(0.8 * done); });
    solver = {};
    solver.bounded.max_stretch = trial_bound;
    trial.bounded = run_trial(loaded, scene, [&](double done) { report_progress(0.8 + 0.2 * done); });
  } catch (const InputError& error) {
    trial.refusal = error.what();
  }
  return trial;
}

std::vector<GarmentTrial> try_garments(const ProgressCallback& report_progress) {
  std::vector<std::pair<std::string, const char*>> models;
  for (const auto& [file, kind] : samples) {
    models.emplace_back(find_asset(std::string("garments/samples/") + file).value_or(file).string(), kind);
  }
  for (const int triangles : model_sizes) {
    models.emplace_back(shirt_scene("tshirt-gravity", triangles).garment.file.string(), "a sewn T-shirt");
  }
  std::vector<GarmentTrial> trials;
  for (const auto& [file, kind] : models) {
    trials.push_back(try_garment(file, kind, [&](double fraction) {
      report_progress((static_cast<double>(trials.size()) + fraction) / static_cast<double>(models.size()));
    }));
  }
  return trials;
}

StraightLine fit_line(std::span<const std::array<double, 2>> points) {
  const auto n = static_cast<double>(points.size());
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (const auto& [x, y] : points) {
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  StraightLine line;
  line.slope = (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
  line.offset = (sum_y - line.slope * sum_x) / n;
  double squares = 0.0;
  for (const auto& [x, y] : points) {
    const double distance = y - line.offset - line.slope * x;
    squares += distance * distance;
  }
  line.misfit = std::sqrt(squares / n);
  return line;
}

PowerLaw fit_power_law(std::span<const std::array<double, 2>> points) {
  std::vector<std::array<double, 2>> logarithms;
  for (const auto& [x, y] : points) logarithms.push_back({std::log(x), std::log(y)});
  const StraightLine line = fit_line(logarithms);
  return {line.slope, std::exp(line.offset), line.misfit};
}

double FrameTimes::median_ms() const { return median(frame_ms); }

double FrameTimes::shortest_ms() const { return *std::ranges::min_element(frame_ms); }

double FrameTimes::longest_ms() const { return *std::ranges::max_element(frame_ms); }

void measure_frame_times(int repeats, const ProgressCallback& report_progress, Results& results) {
  std::vector<TimedRun> runs = make_timed_runs();
  for (TimedRun& run : runs) {
    // The first frame fills the caches.
    run.simulation.advance_frame(throw_if_interrupted);
  }
  // In turn: what else the machine does meanwhile meets all of them alike.
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (TimedRun& run : runs) time_frame(run);
    report_progress(static_cast<double>(repeat + 1) / repeats);
  }
  for (TimedRun& run : runs) {
    (run.times.substeps > 0 ? results.frame_times : results.bounded_times).push_back(std::move(run.times));
  }
}

PowerLaw fit_power_law(const std::vector<FrameTimes>& times, int substeps) {
  std::vector<std::array<double, 2>> points;
  for (const FrameTimes& time : times) {
    if (time.substeps == substeps) {
      points.push_back({static_cast<double>(time.triangles), time.shortest_ms()});
    }
  }
  return fit_power_law(points);
}

TimeGrowth measure_growth(const std::vector<FrameTimes>& times, int substeps) {
  std::vector<std::array<double, 2>> points;
  for (const FrameTimes& time : times) {
    if (time.substeps == substeps) {
      // In thousands of triangles: squares of more would cost digits.
      points.push_back({1e-3 * time.triangles, std::log(time.shortest_ms())});
    }
  }
  const PowerLaw power = fit_power_law(times, substeps);
  return {power.exponent, power.misfit, fit_line(points).misfit};
}

}  // namespace taut::app
