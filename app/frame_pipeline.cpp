#include "app/frame_pipeline.hpp"

#include <thread>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

// Frames that may wait between two stages. More even out frames of different cost better and take more
// memory.
constexpr std::size_t waiting_frames = 3;

template <class Stage> std::exception_ptr error_of(const Stage& stage) {
  try {
    stage();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

void run_in_turn(const FrameStages& stages) {
  while (std::optional<FrameInWork> frame = stages.simulate()) {
    stages.draw(*frame);
    stages.write(*frame);
  }
}

void run_gathered(const FrameStages& stages,
                  const std::function<void(std::span<const FrameInWork>)>& gathered) {
  std::vector<FrameInWork> frames;
  std::exception_ptr simulating_failed;
  try {
    while (std::optional<FrameInWork> frame = stages.simulate()) frames.push_back(std::move(*frame));
  } catch (const Interrupted&) {
    throw;
  } catch (...) {
    simulating_failed = std::current_exception();
  }
  gathered(frames);
  FrameStages rest = stages;
  rest.simulate = [next = std::size_t{0}, &frames]() mutable {
    return next < frames.size() ? std::optional(std::move(frames[next++])) : std::nullopt;
  };
  run_overlapped(rest);
  if (simulating_failed != nullptr) std::rethrow_exception(simulating_failed);
}

void run_overlapped(const FrameStages& stages) {
  BoundedQueue<FrameInWork> simulated(waiting_frames);
  BoundedQueue<FrameInWork> drawn(waiting_frames);
  std::exception_ptr simulating_failed;
  std::exception_ptr writing_failed;

  std::thread simulating([&] {
    simulating_failed = error_of([&] {
      std::optional<FrameInWork> frame = stages.simulate();
      while (frame && simulated.push(std::move(*frame))) frame = stages.simulate();
    });
    simulated.close();
  });
  std::thread writing([&] {
    writing_failed = error_of([&] {
      while (std::optional<FrameInWork> frame = drawn.pop()) stages.write(*frame);
    });
    drawn.abandon();
  });
  const std::exception_ptr drawing_failed = error_of([&] {
    std::optional<FrameInWork> frame = simulated.pop();
    while (frame) {
      stages.draw(*frame);
      frame = drawn.push(std::move(*frame)) ? simulated.pop() : std::nullopt;
    }
  });
  drawn.close();
  simulated.abandon();
  simulating.join();
  writing.join();

  // A later stage works on an earlier frame.
  for (const std::exception_ptr& error : std::array{writing_failed, drawing_failed, simulating_failed}) {
    if (error != nullptr) std::rethrow_exception(error);
  }
}

}  // namespace taut::app
