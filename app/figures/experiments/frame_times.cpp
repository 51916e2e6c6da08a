#include "app/base/interruption.hpp"
#include "app/base/ranks.hpp"
#include "app/base/stopwatch.hpp"
#include "app/figures/experiments/experiments.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {
namespace {

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

}  // namespace taut::app
