#include "app/figures/experiments/experiments.hpp"

#include "app/base/progress.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/runs/frame_verifier.hpp"

namespace taut::app {
namespace {

Recording begin_recording(const DrawnScene& scene, const sim::Simulation& simulation) {
  Recording recording;
  recording.scene = scene;
  recording.garment = simulation.shared_garment();
  recording.pins = simulation.pins().vertices;
  return recording;
}

void keep(const sim::Simulation& simulation, int frame, Recording& recording) {
  recording.moments.push_back({measure_frame(simulation, frame), simulation.state().current});
}

/// Counts the crossings of a frame and its largest stretch, without ending the run if a promise is broken.
void count_promises(const sim::Simulation& simulation, FrameVerifier& verifier, FrameRecord& record,
                    PromiseCounts& counts) {
  verifier.check(simulation, record);
  counts.frames = verifier.frames();
  counts.stretch = verifier.largest();
  counts.crossing_pairs += *record.crossing_pairs;
  counts.max_pairs = std::max(counts.max_pairs, *record.crossing_pairs);
  counts.crossing_frames += *record.crossing_pairs > 0 ? 1 : 0;
}

struct PatchView {
  sim::Vec3 origin_m, right, up;
};

SpringPatch make_patch(const sim::Garment& garment, const std::vector<sim::Index>& vertices, const PatchView& view) {
  SpringPatch patch;
  std::map<sim::Index, std::size_t> place;
  for (const sim::Index vertex : vertices) {
    place[vertex] = patch.points_m.size();
    const sim::Vec3 from_origin = garment.mesh.positions[vertex] - view.origin_m;
    patch.points_m.emplace_back(glm::dot(from_origin, view.right), glm::dot(from_origin, view.up));
  }
  const sim::Springs& springs = garment.springs;
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
      const auto a = place.find(springs.ends[s][0]), b = place.find(springs.ends[s][1]);
      if (a != place.end() && b != place.end()) patch.springs.push_back({{a->second, b->second}, kind});
    }
  }
  return patch;
}

sim::Vec3 normal_around(const sim::Garment& garment, const std::vector<sim::Index>& vertices) {
  sim::Vec3 normal(0.0);
  for (const sim::Triangle& triangle : garment.mesh.triangles) {
    if (std::ranges::all_of(triangle,
                            [&](sim::Index corner) { return std::ranges::find(vertices, corner) != vertices.end(); })) {
      normal += sim::doubled_area_vector(garment.mesh.positions, triangle);
    }
  }
  return glm::normalize(normal);
}

void map_models(Results& results) {
  results.grid_patch = whole_patch(sim::make_garment(sim::make_grid({.columns = 5, .rows = 5})));
  const LoadedGarment loaded = load_garment(shirt_scene("tshirt-gravity", model_sizes.front()));
  const sim::Garment& shirt = *loaded.garment;
  // The middle of the chest is flat and away from every seam.
  const sim::Vec3 chest_m(0.06, 1.25, 0.11);
  results.shirt_patch = patch_around(shirt, nearest_vertex(shirt.mesh.positions, chest_m).vertex, 2);
}

StepRecording record_fall(const ProgressCallback& report_progress, Checking checking) {
  DrawnScene scene = find_scene(fall_scene, {});
  scene.simulation.rest.speed_m_per_s = fall_rest_m / fall_rest_s;
  scene.simulation.rest.frames = static_cast<int>(std::lround(fall_rest_s * scene.simulation.frame_rate_hz));
  return record_steps(scene, fall_frames, followed_vertex(scene), report_progress, checking);
}

void run_methods(Results& results, const ProgressCallback& report_progress) {
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) {
      results.methods.push_back(run_method(kind, rate_hz, methods_duration_s));
      report_progress(static_cast<double>(results.methods.size()) / 6.0);
    }
  }
}

// {substeps, sweeps}: one long step with several sweeps, and many short steps with one sweep. The second stretches far
// less.
constexpr std::array<std::array<int, 2>, 2> measured_settings = {{{1, 10}, {100, 1}}};

struct TimedRun {
  sim::Simulation simulation;
  FrameTimes times;
};

TimedRun make_timed_run(int triangles, DrawnScene scene) {
  // Times the method alone, without contact.
  scene.simulation.solver.bounded.contact = false;
  const bool is_strong = scene.simulation.solver.kind == sim::SolverKind::strong;
  const FrameTimes times = {.triangles = triangles,
                            .substeps = is_strong ? scene.simulation.solver.substeps.value_or(0) : 0,
                            .sweeps = is_strong ? scene.simulation.solver.strong.iterations : 0,
                            .frame_ms = {}};
  return {make_simulation(scene, load_garment(scene)), times};
}

std::vector<TimedRun> make_timed_runs() {
  std::vector<TimedRun> runs;
  for (const auto& [substeps, sweeps] : measured_settings) {
    for (const int triangles : model_sizes) {
      DrawnScene scene = strong_shirt_scene(triangles);
      scene.simulation.solver.substeps = substeps;
      scene.simulation.solver.strong.iterations = sweeps;
      runs.push_back(make_timed_run(triangles, std::move(scene)));
    }
  }
  for (const int triangles : model_sizes) {
    runs.push_back(make_timed_run(triangles, shirt_scene(shirt_scenes[0], triangles)));
  }
  return runs;
}

void time_frame(TimedRun& run) {
  const Stopwatch stopwatch(CLOCK_THREAD_CPUTIME_ID);
  run.simulation.advance_frame(throw_if_interrupted);
  run.times.frame_ms.push_back(stopwatch.elapsed_ms());
  const double stretch = sim::measure_stretch(run.simulation.garment().springs, run.simulation.state().current).max;
  run.times.max_stretch_seen = std::max(run.times.max_stretch_seen, stretch);
}

}  // namespace

void add_stretch(const FrameRecord& record, Recording& recording) {
  sim::SurfaceStretch& max_surface_stretch = recording.max_surface_stretch;
  recording.max_stretch_seen = std::max(recording.max_stretch_seen, record.stretch.max);
  max_surface_stretch.max = std::max(max_surface_stretch.max, record.surface_stretch.max);
  max_surface_stretch.p99 = std::max(max_surface_stretch.p99, record.surface_stretch.p99);
}

Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const ProgressCallback& report_progress,
                        Checking checking) {
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  Recording recording = begin_recording(scene, simulation);
  FrameVerifier verifier;
  if (frames.front() == 0) keep(simulation, 0, recording);
  FrameOutputs outputs;
  outputs.write_shape = [&](int frame, const sim::Simulation& moment, const auto& /*shown_m*/) {
    if (std::ranges::binary_search(frames, frame)) keep(moment, frame, recording);
  };
  outputs.report = [&](const FrameRecord& record) {
    add_stretch(record, recording);
    report_progress(static_cast<double>(record.frame) / frames.back());
  };
  if (checking == Checking::promises) {
    recording.promises.emplace();
    outputs.verify = [&](const sim::Simulation& moment, FrameRecord& record) {
      count_promises(moment, verifier, record, *recording.promises);
      return std::string();
    };
  }
  run_frames(simulation, frames.back(), outputs);
  return recording;
}

DrawnScene with_steps_as_frames(DrawnScene scene) {
  RunSettings& settings = scene.simulation;
  const int substeps = sim::equal_substeps(solver_settings(settings.solver));
  settings.frame_rate_hz *= substeps;
  settings.solver.substeps = 1;
  settings.rest.frames *= substeps;
  scene.frames *= substeps;
  return scene;
}

StepRecording record_steps(const DrawnScene& scene, std::span<const int> frames, sim::Index vertex,
                           const ProgressCallback& report_progress, Checking checking) {
  const int steps_in_frame = sim::equal_substeps(solver_settings(scene.simulation.solver));
  const DrawnScene stepped = with_steps_as_frames(scene);
  sim::Simulation simulation = make_simulation(stepped, load_garment(stepped));
  StepRecording recording{begin_recording(scene, simulation), simulation.frame_time_s(), vertex, {}, false};
  if (frames.front() == 0) keep(simulation, 0, recording.frames);
  FrameVerifier verifier;
  std::optional<PromiseCounts>& promises = recording.frames.promises;
  if (checking == Checking::promises) {
    FrameRecord start;
    count_promises(simulation, verifier, start, promises.emplace());
  }
  for (int frame = 1; frame <= frames.back() && !recording.came_to_rest; ++frame) {
    for (int step = 0; step < steps_in_frame && !recording.came_to_rest; ++step) {
      simulation.advance_frame(throw_if_interrupted);
      recording.came_to_rest = simulation.state().asleep;
      // Falling asleep stops the cloth; its last movement is the one before.
      if (!recording.came_to_rest) recording.moved_m.push_back(sim::vertex_convergence_m(simulation.change(), vertex));
    }
    FrameRecord record;
    record.time_s = simulation.state().time_s;
    measure_stretches(simulation, record);
    add_stretch(record, recording.frames);
    if (promises) count_promises(simulation, verifier, record, *promises);
    if (recording.came_to_rest || std::ranges::binary_search(frames, frame)) keep(simulation, frame, recording.frames);
    report_progress(static_cast<double>(frame) / frames.back());
  }
  return recording;
}

std::size_t SpringPatch::count(sim::SpringKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(springs, kind, &PatchSpring::kind));
}

SpringPatch whole_patch(const sim::Garment& garment) {
  std::vector<sim::Index> all(garment.mesh.positions.size());
  std::iota(all.begin(), all.end(), sim::Index{0});
  return make_patch(garment, all, {sim::Vec3(0.0), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
}

SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings) {
  std::vector<sim::Index> vertices = {vertex};
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<sim::Index> inner = vertices;
    for (const sim::Index v : inner) {
      for (const sim::Index edge : garment.adjacency.vertex_edges[v]) {
        const sim::Index neighbour = sim::other_end(garment.adjacency.edges[edge], v);
        if (std::ranges::find(vertices, neighbour) == vertices.end()) vertices.push_back(neighbour);
      }
    }
  }
  const sim::Vec3 normal = normal_around(garment, vertices);
  const sim::Vec3 right = glm::normalize(glm::cross(sim::Vec3(0.0, 1.0, 0.0), normal));
  return make_patch(garment, vertices, {garment.mesh.positions[vertex], right, glm::cross(normal, right)});
}

std::vector<Job> experiments(Results& results, Checking checking) {
  std::vector<Job> jobs = {
      {"mapping", 0.1, [&results](const ProgressCallback&) { map_models(results); }},
      {fall_scene, 10.0,
       [&results, checking](const ProgressCallback& report) { results.fall = record_fall(report, checking); }},
      {"methods", 0.3, [&results](const ProgressCallback& report) { run_methods(results, report); }}};
  // Adds a run that keeps the scene's last frame.
  const auto add = [&jobs, checking](const char* name, double cost, std::optional<Recording>& place) {
    jobs.push_back({name, cost, [=, &place](const ProgressCallback& report) {
                      const DrawnScene scene = find_scene(name, {});
                      place = record_frames(scene, std::array{scene.frames}, report, checking);
                    }});
  };
  for (std::size_t i = 0; i < pinned_scenes.size(); ++i) add(pinned_scenes[i], 0.1, results.pinned[i]);
  const std::array costs = {16.0, 16.0, 62.0};
  for (std::size_t i = 0; i < shirt_scenes.size(); ++i) add(shirt_scenes[i], costs[i], results.shirts[i]);
  return jobs;
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
  // Triangles that also resist compression would lock, and the shirt would not fall into folds.
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
  if (run.diverged_at_s || run.moved_rms_m.empty()) return std::nullopt;
  const std::size_t begin = run.moved_rms_m.size() - (run.moved_rms_m.size() + 3) / 4;
  double squares = 0.0;
  for (std::size_t i = begin; i < run.moved_rms_m.size(); ++i) squares += run.moved_rms_m[i] * run.moved_rms_m[i];
  const double max_fraction =
      *std::max_element(run.max_stretch.begin() + static_cast<std::ptrdiff_t>(begin), run.max_stretch.end());
  const auto count = static_cast<double>(run.moved_rms_m.size() - begin);
  return Unrest{std::sqrt(squares / count) / run.time_step_s, max_fraction};
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
  line.rms_residual = std::sqrt(squares / n);
  return line;
}

PowerLaw fit_power_law(std::span<const std::array<double, 2>> points) {
  std::vector<std::array<double, 2>> logarithms;
  for (const auto& [x, y] : points) logarithms.push_back({std::log(x), std::log(y)});
  const StraightLine line = fit_line(logarithms);
  return {line.slope, std::exp(line.offset), line.rms_residual};
}

double FrameTimes::median_ms() const { return median(frame_ms); }

void measure_frame_times(int repeats, const ProgressCallback& report_progress, Results& results) {
  std::vector<TimedRun> runs = make_timed_runs();
  for (TimedRun& run : runs) {
    // Fills the caches.
    run.simulation.advance_frame(throw_if_interrupted);
  }
  // The runs take turns, so that other work of the machine affects all of them equally.
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
    if (time.substeps == substeps) points.push_back({static_cast<double>(time.triangles), time.min_ms()});
  }
  return fit_power_law(points);
}

}  // namespace taut::app
