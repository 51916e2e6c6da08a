#include "app/figures/experiments/recording.hpp"

#include "app/base/interruption.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/output/frame_verifier.hpp"

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

/// Counts in a recording what frames are promised, whether it is kept or not.
class PromiseCounter {
 public:
  explicit PromiseCounter(Recording& recording) : counts_(recording.promises.emplace()) {}

  void count(const sim::Simulation& simulation, FrameRecord& record) {
    verifier_.check(simulation, record);
    counts_.frames = verifier_.frames();
    counts_.stretch = verifier_.largest();
    counts_.crossing_pairs += *record.crossing_pairs;
    counts_.most_pairs = std::max(counts_.most_pairs, *record.crossing_pairs);
    counts_.crossing_frames += *record.crossing_pairs > 0 ? 1 : 0;
  }

 private:
  PromiseCounts& counts_;
  FrameVerifier verifier_;
};

}  // namespace

void note_stretch(const FrameRecord& record, Recording& recording) {
  sim::SurfaceStretch& largest = recording.largest_surface_stretch;
  recording.largest_stretch = std::max(recording.largest_stretch, record.stretch.max);
  largest.max = std::max(largest.max, record.surface_stretch.max);
  largest.p99 = std::max(largest.p99, record.surface_stretch.p99);
}

Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const ProgressCallback& report_progress,
                        Checking checking) {
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  Recording recording = begin_recording(scene, simulation);
  std::optional<PromiseCounter> counter;
  if (frames.front() == 0) keep(simulation, 0, recording);
  FrameOutputs outputs;
  outputs.write_shape = [&](int frame, const sim::Simulation& moment) {
    if (std::ranges::binary_search(frames, frame)) keep(moment, frame, recording);
  };
  outputs.report = [&](const FrameRecord& record) {
    note_stretch(record, recording);
    report_progress(static_cast<double>(record.frame) / frames.back());
  };
  if (checking == Checking::promises) {
    counter.emplace(recording);
    outputs.verify = [&](const sim::Simulation& moment, FrameRecord& record) {
      counter->count(moment, record);
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
  std::optional<PromiseCounter> counter;
  if (checking == Checking::promises) {
    counter.emplace(recording.frames);
    FrameRecord start;
    counter->count(simulation, start);
  }
  for (int frame = 1; frame <= frames.back() && !recording.came_to_rest; ++frame) {
    for (int step = 0; step < steps_in_frame && !recording.came_to_rest; ++step) {
      simulation.advance_frame(throw_if_interrupted);
      recording.came_to_rest = simulation.state().asleep;
      // Cloth that is put to sleep is stopped; until then it moved.
      if (!recording.came_to_rest) {
        recording.moved_m.push_back(sim::convergence_of(simulation.change(), vertex));
      }
    }
    FrameRecord record;
    record.time_s = simulation.state().time_s;
    measure_stretches(simulation, record);
    note_stretch(record, recording.frames);
    if (counter) counter->count(simulation, record);
    if (recording.came_to_rest || std::ranges::binary_search(frames, frame)) {
      keep(simulation, frame, recording.frames);
    }
    report_progress(static_cast<double>(frame) / frames.back());
  }
  return recording;
}

}  // namespace taut::app
