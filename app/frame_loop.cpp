#include "app/frame_loop.hpp"

#include <thread>

#include "app/base/progress.hpp"

namespace taut::app {
namespace {

// Frames that may wait between two stages. A larger number evens out the different costs of frames better, and takes
// more memory.
constexpr std::size_t max_waiting_frames = 3;

template <class Stage> std::exception_ptr catch_error(const Stage& stage) {
  try {
    stage();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

bool is_drawn(int frame, const FrameOutputs& outputs) { return std::ranges::binary_search(outputs.pictures, frame); }

void advance(sim::Simulation& simulation, int frame) {
  try {
    simulation.advance_frame(throw_if_interrupted);
  } catch (const sim::ContactBlocked& error) {
    throw FrameBlocked(frame, error);
  }
}

FrameInWork simulate_frame(sim::Simulation& simulation, int frame, const FrameOutputs& outputs) {
  FrameInWork work;
  const Stopwatch simulating(CLOCK_THREAD_CPUTIME_ID);
  if (frame > outputs.start_frame) advance(simulation, frame);
  const double sim_ms = simulating.elapsed_ms();
  work.record = measure_frame(simulation, frame, outputs.measured);
  work.record.sim_ms = sim_ms;
  if (outputs.verify) work.broken = outputs.verify(simulation, work.record);
  if (!work.broken.empty()) return work;

  const std::vector<sim::Vec3>& positions_m = simulation.state().current;
  if (outputs.show) work.shown_m = outputs.show(positions_m);
  if (outputs.write_shape) {
    Stopwatch writing;
    outputs.write_shape(frame, simulation, work.shown_m.empty() ? positions_m : work.shown_m);
    work.record.encode_ms = writing.elapsed_ms();
  }
  if (is_drawn(frame, outputs)) work.positions = positions_m;
  return work;
}

void require_promises_kept(const std::string& broken) {
  if (!broken.empty()) throw PromiseBroken(broken);
}

/// Verifies a start frame that is not handed out.
void verify_start(const sim::Simulation& simulation, const FrameOutputs& outputs) {
  if (outputs.verify) {
    FrameRecord record = measure_frame(simulation, outputs.start_frame);
    require_promises_kept(outputs.verify(simulation, record));
  }
}

void draw_frame(FrameInWork& work, const FrameOutputs& outputs) {
  Stopwatch drawing;
  work.picture = outputs.draw(work);
  work.record.draw_ms = drawing.elapsed_ms();
}

void write_frame(FrameInWork& work, const FrameOutputs& outputs) {
  Stopwatch writing;
  outputs.write_frame(work.record, work.picture);
  work.record.encode_ms += writing.elapsed_ms();
}

}  // namespace

void run_in_turn(const FrameStages& stages) {
  while (std::optional<FrameInWork> frame = stages.simulate()) {
    stages.draw(*frame);
    stages.write(*frame);
  }
}

void run_simulation_first(const FrameStages& stages,
                          const std::function<void(std::span<const FrameInWork>)>& gathered) {
  std::vector<FrameInWork> frames;
  std::exception_ptr simulating_failed;
  try {
    while (std::optional<FrameInWork> frame = stages.simulate()) frames.push_back(std::move(*frame));
  } catch (const ModelOverstretched&) {
    throw;
  } catch (const Interrupted&) {
    // The frames took long; drawing them does not. A second signal ends the program at once.
    forget_interruption();
    simulating_failed = std::current_exception();
  } catch (...) {
    simulating_failed = std::current_exception();
  }
  gathered(frames);
  FrameStages other_stages = stages;
  other_stages.simulate = [next = std::size_t{0}, &frames]() mutable {
    return next < frames.size() ? std::optional(std::move(frames[next++])) : std::nullopt;
  };
  run_overlapped(other_stages);
  if (simulating_failed != nullptr) std::rethrow_exception(simulating_failed);
}

void run_overlapped(const FrameStages& stages) {
  BoundedQueue<FrameInWork> simulated(max_waiting_frames);
  BoundedQueue<FrameInWork> drawn(max_waiting_frames);
  std::exception_ptr simulating_failed;
  std::exception_ptr writing_failed;

  std::thread simulating([&] {
    simulating_failed = catch_error([&] {
      std::optional<FrameInWork> frame = stages.simulate();
      while (frame && simulated.push(std::move(*frame))) frame = stages.simulate();
    });
    simulated.close();
  });
  std::thread writing([&] {
    writing_failed = catch_error([&] {
      while (std::optional<FrameInWork> frame = drawn.pop()) stages.write(*frame);
    });
    drawn.close();
  });
  const std::exception_ptr drawing_failed = catch_error([&] {
    std::optional<FrameInWork> frame = simulated.pop();
    while (frame) {
      stages.draw(*frame);
      frame = drawn.push(std::move(*frame)) ? simulated.pop() : std::nullopt;
    }
  });
  drawn.close();
  simulated.close();
  simulating.join();
  writing.join();

  // Errors of later stages come first, because these stages work on earlier frames.
  for (const std::exception_ptr& error : std::array{writing_failed, drawing_failed, simulating_failed}) {
    if (error != nullptr) std::rethrow_exception(error);
  }
}

FrameBlocked::FrameBlocked(int blocked_frame, const sim::ContactBlocked& error)
    : PromiseBroken("frame " + std::to_string(blocked_frame) + ": " + error.what()),
      frame(blocked_frame),
      blocked(error.blocked()) {}

std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame, const FrameOutputs& outputs) {
  std::vector<FrameRecord> records;
  const bool hands_out_start = outputs.with_start || is_drawn(outputs.start_frame, outputs);
  int next_frame = outputs.start_frame + (hands_out_start ? 0 : 1);
  if (!hands_out_start) verify_start(simulation, outputs);
  const bool overlaps = outputs.overlap && outputs.pictures.size() > 1;
  // An overlapped run drops the frames that wait between stages. A run in turn has none.
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
    run_simulation_first(stages, outputs.before_drawing);
  } else if (overlaps) {
    run_overlapped(stages);
  } else {
    run_in_turn(stages);
  }
  return records;
}

}  // namespace taut::app
