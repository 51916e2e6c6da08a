#include <algorithm>

#include "app/figures/experiments.hpp"
#include "app/garment/garment_loading.hpp"
#include "app/stopwatch.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

struct StepSettings {
  int substeps;
  int sweeps;
};

// One long step with a few sweeps, and many short ones, which stretch far less.
constexpr std::array<StepSettings, 2> measured_settings = {{{1, 10}, {100, 1}}};

sim::Simulation timed_simulation(int triangles, const StepSettings& settings) {
  Scene scene = literal_shirt_scene(triangles);
  scene.simulation.solver.substeps = settings.substeps;
  scene.simulation.solver.iterations = settings.sweeps;
  // The method alone: layers are another matter, and their distance depends on the model.
  scene.surroundings.layer_distance_m = 0.0;
  return make_simulation(scene, load_garment(scene));
}

}  // namespace

double FrameTimes::median_ms() const {
  std::vector<double> sorted = frame_ms;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double FrameTimes::shortest_ms() const {
  return *std::min_element(frame_ms.begin(), frame_ms.end());
}

double FrameTimes::longest_ms() const {
  return *std::max_element(frame_ms.begin(), frame_ms.end());
}

std::vector<FrameTimes> measure_frame_times(int repeats, const Checkpoint& checkpoint) {
  std::vector<FrameTimes> times;
  std::vector<sim::Simulation> simulations;
  for (const StepSettings& settings : measured_settings) {
    for (const int triangles : model_sizes) {
      simulations.push_back(timed_simulation(triangles, settings));
      simulations.back().advance_frame();
      times.push_back({triangles, settings.substeps, settings.sweeps, {}});
    }
  }
  // In turn: what else the machine does meanwhile meets all of them alike.
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < simulations.size(); ++i) {
      const Stopwatch stopwatch;
      simulations[i].advance_frame();
      times[i].frame_ms.push_back(stopwatch.elapsed_ms());
    }
    checkpoint(static_cast<double>(repeat + 1) / repeats);
  }
  return times;
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
