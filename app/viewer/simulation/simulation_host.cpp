#include "app/viewer/simulation/simulation_host.hpp"

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"

namespace taut::app {
namespace {

// Delay beyond which a simulation gives up time: it then runs slower instead of catching up.
constexpr std::chrono::milliseconds max_delay{50};
/// Maximum time that closing a window waits.
constexpr std::chrono::milliseconds max_stop_time{500};

// Limit on the simulated time to catch up with after a slow frame of the window.
constexpr double max_owed_s = 0.1;
// Rounding must not skip a frame: frames of window and simulation both take 1/60 s.
constexpr double rounding_s = 1e-9;

}  // namespace

SimulationPair::SimulationPair(const SceneWithBodies& scene) : first_(scene), settings_(first_.loaded()->scene) {}

void SimulationPair::apply(const SimulationCommand& command) {
  if (const auto* asked = std::get_if<Compare>(&command)) return compare(*asked);
  const std::shared_ptr<const LoadedScene> before = first_.loaded();
  const bool was_stopped = first_.is_stopped();
  const auto* change = std::get_if<ChangeSettings>(&command);
  first_.apply(command);
  if (change != nullptr) {
    settings_ = *change;
  } else if (first_.loaded() != before) {
    settings_ = ChangeSettings(first_.loaded()->scene);
  }
  const bool restarts = std::holds_alternative<Reset>(command) || (change != nullptr && was_stopped);
  if (restarts || first_.loaded() != before) {
    begin_second();
  } else if (second_) {
    pass_on(command);
  }
}

void SimulationPair::compare(const Compare& asked) {
  kind_ = asked.with;
  if (kind_) first_.apply(Reset{});
  begin_second();
  if (second_) first_.tell(std::string("compared with ") + sim::to_name(*kind_) + ": both begin anew", false);
}

ChangeSettings SimulationPair::own_settings() const {
  ChangeSettings settings = settings_;
  SolverChoice& solver = settings.simulation.solver;
  solver = with_solver(solver, *kind_, first_.loaded()->scene.simulation.solver);
  return settings;
}

void SimulationPair::begin_second() {
  second_.reset();
  told_notice_ = 0;
  if (!kind_) return;
  try {
    LoadedScene own = *first_.loaded();
    own.scene.simulation = own_settings().simulation;
    second_.emplace(std::make_shared<const LoadedScene>(std::move(own)));
    second_->apply(own_settings());
    second_->apply(SetPaused{first_.is_paused()});
    pass_on_notices();
  } catch (const std::exception& error) {
    first_.tell(std::string(sim::to_name(*kind_)) + ": " + error.what(), true);
  }
}

void SimulationPair::pass_on(const SimulationCommand& command) {
  if (std::holds_alternative<ChangeSettings>(command)) {
    // New settings would restart a stopped simulation while the first one continues.
    if (!second_->is_stopped()) second_->apply(own_settings());
  } else if (const auto* back = std::get_if<GoBack>(&command)) {
    // A simulation that had stopped by then does not change.
    if (back->to->compared && !back->to->compared->stopped) second_->apply(GoBack{back->to->compared});
  } else {
    second_->apply(command);
  }
  pass_on_notices();
}

void SimulationPair::pass_on_notices() {
  for (const Notice& notice : second_->notices()) {
    if (notice.number > told_notice_) {
      told_notice_ = notice.number;
      first_.tell(std::string(sim::to_name(*kind_)) + ": " + notice.text, notice.is_error);
    }
  }
}

void SimulationPair::advance(const std::function<void()>& poll) {
  first_.advance(poll);
  if (second_) {
    second_->advance(poll);
    pass_on_notices();
  }
}

SnapshotPtr SimulationPair::take_snapshot() {
  return first_.take_snapshot(second_ ? second_->take_snapshot() : nullptr);
}

SimulationHost::SimulationHost(const SceneWithBodies& scene, Runs runs)
    : runs_(runs), simulation_(scene), due_(Clock::now()) {
  timeline_.add(simulation_.take_snapshot());
  if (runs == Runs::by_itself) thread_ = std::thread([this] { run(); });
}

void SimulationHost::end() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, max_stop_time, [this] { return !busy_; });
    gives_up_ = is_in_frame_;
  }
  if (thread_.joinable()) thread_.join();
}

SnapshotPtr SimulationHost::begin_frame(double elapsed_s, const std::optional<Pace>& pace) {
  const std::lock_guard lock(mutex_);
  if (runs_ == Runs::by_itself) return timeline_.newest();
  if (!pace) {
    follow_clock(elapsed_s);
    return timeline_.newest();
  }
  follow(*pace);
  return timeline_.with_serial(pace->shown);
}

std::uint64_t SimulationHost::post(std::vector<SimulationCommand> commands) {
  const std::lock_guard lock(mutex_);
  const bool has_any = !commands.empty();
  if (runs_ == Runs::by_itself) {
    if (has_any) {
      posted_.push_back(std::move(commands));
      changed_.notify_all();
    }
    return begun_;
  }
  for (const SimulationCommand& command : commands) simulation_.apply(command);
  if (has_any) timeline_.add(simulation_.take_snapshot());
  return simulation_.advances();
}

SnapshotPtr SimulationHost::past_frame(const SnapshotPtr& now, int frame) {
  const std::lock_guard lock(mutex_);
  return timeline_.of_frame(now, frame);
}

double SimulationHost::take_given_up_ms() {
  const std::lock_guard lock(mutex_);
  return std::chrono::duration<double, std::milli>(std::exchange(given_up_, {})).count();
}

double SimulationHost::worked_ms() {
  const std::lock_guard lock(mutex_);
  return worked_ms_;
}

std::uint64_t SimulationHost::state_hash() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_ && posted_.empty(); });
  return simulation_.state_hash();
}

void SimulationHost::run() {
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

// Waits until the next frame is due and computes it. Commands that arrive meanwhile are done first.
void SimulationHost::wait_until_due(std::unique_lock<std::mutex>& lock) {
  changed_.wait_until(lock, due_, [this] { return ending_ || !posted_.empty(); });
  if (ending_ || !posted_.empty()) return;
  const auto frame_time = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(simulation_.frame_time_s() / simulation_.speed()));
  const Clock::time_point next_due = due_ + frame_time;
  due_ = std::max(next_due, Clock::now() - max_delay);
  if (worked_ms_ < std::chrono::duration<double, std::milli>(frame_time).count()) given_up_ += due_ - next_due;
  advance(lock);
}

void SimulationHost::perform_posted(std::unique_lock<std::mutex>& lock) {
  const std::vector<SimulationCommand> commands = std::move(posted_.front());
  posted_.pop_front();
  busy_ = true;
  lock.unlock();
  for (const SimulationCommand& command : commands) simulation_.apply(command);
  SnapshotPtr snapshot = simulation_.take_snapshot();
  lock.lock();
  timeline_.add(std::move(snapshot));
  busy_ = false;
  changed_.notify_all();
}

void SimulationHost::advance(std::unique_lock<std::mutex>& lock) {
  ++begun_;
  busy_ = is_in_frame_ = true;
  lock.unlock();
  const Stopwatch working(CLOCK_THREAD_CPUTIME_ID);
  try {
    simulation_.advance([this] {
      if (gives_up_) throw Interrupted(0);
    });
  } catch (const Interrupted&) {
    // The shown state has not changed.
  }
  SnapshotPtr snapshot = simulation_.take_snapshot();
  const double worked_ms = working.elapsed_ms();
  lock.lock();
  worked_ms_ = worked_ms;
  timeline_.add(std::move(snapshot));
  busy_ = is_in_frame_ = false;
  changed_.notify_all();
}

void SimulationHost::advance_as_asked() {
  simulation_.advance(throw_if_interrupted);
  timeline_.add(simulation_.take_snapshot());
}

void SimulationHost::follow_clock(double elapsed_s) {
  owed_s_ = std::min(owed_s_ + elapsed_s * simulation_.speed(), max_owed_s);
  while (simulation_.wants_to_advance() && owed_s_ + rounding_s >= simulation_.frame_time_s()) {
    owed_s_ -= simulation_.frame_time_s();
    advance_as_asked();
  }
  if (!simulation_.wants_to_advance()) owed_s_ = 0.0;
}

void SimulationHost::follow(const Pace& pace) {
  constexpr std::uint64_t max_frames_at_once = 100000;
  if (pace.advances < simulation_.advances() || pace.advances > simulation_.advances() + max_frames_at_once) {
    throw InputError("the session says {} simulated frames after {} of them", pace.advances, simulation_.advances());
  }
  while (simulation_.advances() < pace.advances) advance_as_asked();
}

}  // namespace taut::app
