#include "app/viewer/simulation/simulation_thread.hpp"

#include <time.h>

#include <algorithm>
#include <utility>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

// A simulation that falls behind the clock by more gives the time up: it runs slower, and never hurries to
// catch up.
constexpr std::chrono::milliseconds most_behind{50};
/// Whoever closes a window waits no longer.
constexpr std::chrono::milliseconds longest_end{500};

// That the calling thread has had.
std::chrono::nanoseconds processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

SimulationThread::SimulationThread(const DrawnScene& scene) : simulation_(scene), due_(Clock::now()) {
  timeline_.add(simulation_.take_snapshot());
  thread_ = std::thread([this] { run(); });
}

SimulationThread::~SimulationThread() {
  end();
}

void SimulationThread::end() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest_end, [this] { return !busy_; });
    gives_up_ = is_in_frame_;
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

SnapshotPtr SimulationThread::begin_frame(double, const std::optional<Pace>&) {
  const std::lock_guard lock(mutex_);
  return timeline_.newest();
}

std::uint64_t SimulationThread::post(std::vector<SimulationCommand> commands) {
  const std::lock_guard lock(mutex_);
  if (!commands.empty()) {
    posted_.push_back(std::move(commands));
    changed_.notify_all();
  }
  return begun_;
}

SnapshotPtr SimulationThread::past_frame(const SnapshotPtr& now, int frame) {
  const std::lock_guard lock(mutex_);
  return timeline_.of_frame(now, frame);
}

double SimulationThread::take_given_up_ms() {
  const std::lock_guard lock(mutex_);
  return std::chrono::duration<double, std::milli>(std::exchange(given_up_, {})).count();
}

double SimulationThread::worked_ms() {
  const std::lock_guard lock(mutex_);
  return std::chrono::duration<double, std::milli>(worked_).count();
}

std::uint64_t SimulationThread::state_hash() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_ && posted_.empty(); });
  return simulation_.state_hash();
}

void SimulationThread::run() {
  std::unique_lock lock(mutex_);
  while (!ending_ || !posted_.empty()) {
    if (!posted_.empty()) {
      perform_posted(lock);
    } else if (simulation_.wants_to_advance()) {
      wait_until_due(lock);
    } else {
      changed_.wait(lock);
      due_ = Clock::now();
    }
  }
}

// Commands that come meanwhile are done first.
void SimulationThread::wait_until_due(std::unique_lock<std::mutex>& lock) {
  changed_.wait_until(lock, due_, [this] { return ending_ || !posted_.empty(); });
  if (ending_ || !posted_.empty()) {
    return;
  }
  const auto frame_time = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(simulation_.frame_time_s() / simulation_.speed()));
  const Clock::time_point next_due = due_ + frame_time;
  due_ = std::max(next_due, Clock::now() - most_behind);
  if (worked_ < frame_time) {
    given_up_ += due_ - next_due;
  }
  advance(lock);
}

void SimulationThread::perform_posted(std::unique_lock<std::mutex>& lock) {
  const std::vector<SimulationCommand> commands = std::move(posted_.front());
  posted_.pop_front();
  busy_ = true;
  lock.unlock();
  for (const SimulationCommand& command : commands) {
    simulation_.apply(command);
  }
  SnapshotPtr snapshot = simulation_.take_snapshot();
  lock.lock();
  timeline_.add(std::move(snapshot));
  busy_ = false;
  changed_.notify_all();
}

void SimulationThread::advance(std::unique_lock<std::mutex>& lock) {
  ++begun_;
  busy_ = is_in_frame_ = true;
  lock.unlock();
  const Clock::duration before = processor_time();
  try {
    simulation_.advance([this] {
      if (gives_up_) {
        throw Interrupted(0);
      }
    });
  } catch (const Interrupted&) {
    // Of what is shown nothing has changed.
  }
  SnapshotPtr snapshot = simulation_.take_snapshot();
  const Clock::duration worked = processor_time() - before;
  lock.lock();
  worked_ = worked;
  timeline_.add(std::move(snapshot));
  busy_ = is_in_frame_ = false;
  changed_.notify_all();
}

}  // namespace taut::app
