#include "app/bench/race.hpp"

#include <algorithm>
#include <array>

#include "sim/simulation.hpp"

namespace taut::app {
namespace {

// Too few frames say nothing: the first fill the caches, and cloth starts unstretched.
constexpr std::size_t frames_before_giving_up = 6;

// As many as find an engine's data in the caches again, as they are where it runs alone; few enough that a
// minute in which the machine is busy meets all engines.
constexpr int frames_in_a_turn = 10;

FrameSample measured(const Engine& engine, const sim::Garment& garment, const FrameCost& cost) {
  const sim::Stretch stretch = sim::measure_stretch(garment.springs, engine.positions());
  return {cost, cost.raw_stretch.value_or(stretch.max), stretch.max, stretch.p99,
          sim::measure_surface_stretch(garment, engine.positions())};
}

RunEnd end_so_far(const std::vector<FrameSample>& frames, const RaceSettings& settings) {
  if (frames.size() < frames_before_giving_up) {
    return RunEnd::finished;
  }
  double sum_ms = 0.0;
  for (const FrameSample& frame : frames) {
    sum_ms += frame.cost.cpu_ms;
  }
  if (sum_ms > settings.slowest_frame_ms * static_cast<double>(frames.size())) {
    return RunEnd::too_slow;
  }
  return frames.back().stretch > settings.hopeless_stretch ? RunEnd::hopeless : RunEnd::finished;
}

bool is_most_stretched(const FrameSample& sample, const std::vector<FrameSample>& earlier) {
  return std::none_of(earlier.begin(), earlier.end(),
                      [&](const FrameSample& frame) { return frame.stretch >= sample.stretch; });
}

void advance(Engine& engine, const sim::Garment& garment, const RaceSettings& settings, Run& run) {
  try {
    const FrameCost cost = engine.advance_frame();
    const FrameSample sample = measured(engine, garment, cost);
    if (is_most_stretched(sample, run.frames)) {
      const std::span<const sim::Vec3> positions = engine.positions();
      run.most_stretched.assign(positions.begin(), positions.end());
    }
    run.frames.push_back(sample);
    run.end = end_so_far(run.frames, settings);
  } catch (const sim::Diverged&) {
    run.end = RunEnd::diverged;
  }
}

}  // namespace

const char* name_of(RunEnd end) {
  constexpr std::array names = {"finished", "diverged", "too slow", "hopeless"};
  return names[static_cast<std::size_t>(end)];
}

std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings, const std::function<void(int)>& after_turn) {
  std::vector<Run> runs;
  std::vector<std::unique_ptr<Engine>> engines;
  for (const Entrant& entrant : entrants) {
    runs.push_back({entrant, {}, RunEnd::finished, {}});
    engines.push_back(entrant.make(cloth, scene));
  }
  for (int begin = 0; begin < settings.frames; begin += frames_in_a_turn) {
    const int end = std::min(begin + frames_in_a_turn, settings.frames);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      for (int frame = begin; frame < end && runs[i].end == RunEnd::finished; ++frame) {
        advance(*engines[i], *cloth.garment, settings, runs[i]);
      }
    }
    after_turn(end);
  }
  return runs;
}

}  // namespace taut::app
