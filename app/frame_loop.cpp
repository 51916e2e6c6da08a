#include "app/frame_loop.hpp"

#include "app/base/interruption.hpp"
#include "app/base/stopwatch.hpp"

namespace taut::app {
namespace {

bool is_drawn(int frame, const FrameOutputs& outputs) {
  return std::ranges::binary_search(outputs.pictures, frame);
}

void advance(sim::Simulation& simulation, int frame) {
  try {
    simulation.advance_frame(throw_if_interrupted);
  } catch (const sim::ContactBlocked& error) {
    throw FrameBlocked(frame, error);
  }
}

FrameInWork simulate_frame(sim::Simulation& simulation, int frame, const FrameOutputs& outputs) {
  FrameInWork work;
  const ProcessorStopwatch simulating;
  if (frame > outputs.start_frame) advance(simulation, frame);
  const double sim_ms = simulating.elapsed_ms();
  work.record = measure_frame(simulation, frame, outputs.measured);
  work.record.sim_ms = sim_ms;
  if (outputs.verify) work.broken = outputs.verify(simulation, work.record);
  if (!work.broken.empty()) return work;

  if (outputs.write_shape) {
    Stopwatch writing;
    outputs.write_shape(frame, simulation);
    work.record.encode_ms = writing.elapsed_ms();
  }
  if (is_drawn(frame, outputs)) work.positions = simulation.state().current;
  return work;
}

void require_promises_kept(const std::string& broken) {
  if (!broken.empty()) throw PromiseBroken(broken);
}

/// Of a start that is not handed out.
void verify_start(const sim::Simulation& simulation, const FrameOutputs& outputs) {
  if (outputs.verify) {
    FrameRecord record = measure_frame(simulation, outputs.start_frame);
    require_promises_kept(outputs.verify(simulation, record));
  }
}

void draw_frame(FrameInWork& work, const FrameOutputs& outputs) {
  Stopwatch drawing;
  work.picture = outputs.draw_positions(work.positions, work.record.time_s);
  work.record.draw_ms = drawing.elapsed_ms();
}

void write_frame(FrameInWork& work, const FrameOutputs& outputs) {
  Stopwatch writing;
  outputs.write_frame(work.record, work.picture);
  work.record.encode_ms += writing.elapsed_ms();
}

}  // namespace

FrameBlocked::FrameBlocked(int blocked_frame, const sim::ContactBlocked& error)
    : PromiseBroken("frame " + std::to_string(blocked_frame) + ": " + error.what()),
      frame(blocked_frame),
      blocked(error.blocked()) {}

std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame,
                                    const FrameOutputs& outputs) {
  std::vector<FrameRecord> records;
  const bool hands_out_start = outputs.with_start || is_drawn(outputs.start_frame, outputs);
  int next_frame = outputs.start_frame + (hands_out_start ? 0 : 1);
  if (!hands_out_start) verify_start(simulation, outputs);
  const bool overlaps = outputs.overlap && outputs.pictures.size() > 1;
  // Frames that wait between two stages are given up, but in turn there are none.
  const auto give_up_if_interrupted = [overlaps] {
    if (overlaps) throw_if_interrupted();
  };

  FrameStages stages;
  bool is_broken = false;
  stages.simulate = [&]() -> std::optional<FrameInWork> {
    throw_if_interrupted();
    if (next_frame > last_frame || is_broken) return std::nullopt;
    FrameInWork work = simulate_frame(simulation, next_frame++, outputs);
    is_broken = !work.broken.empty();
    if (outputs.simulated) outputs.simulated(work.record);
    return work;
  };
  stages.draw = [&](FrameInWork& work) {
    give_up_if_interrupted();
    if (work.broken.empty() && is_drawn(work.record.frame, outputs)) draw_frame(work, outputs);
  };
  stages.write = [&](FrameInWork& work) {
    give_up_if_interrupted();
    if (work.broken.empty() && is_drawn(work.record.frame, outputs)) write_frame(work, outputs);
    records.push_back(work.record);
    if (outputs.report) outputs.report(work.record);
    require_promises_kept(work.broken);
  };
  if (outputs.before_drawing) {
    run_gathered(stages, outputs.before_drawing);
  } else if (overlaps) {
    run_overlapped(stages);
  } else {
    run_in_turn(stages);
  }
  return records;
}

}  // namespace taut::app
