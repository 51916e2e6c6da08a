#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/viewer/session/session.hpp"
#include "app/viewer/simulation/live_simulation.hpp"

namespace taut::app {

/// A live simulation and, on request, a second one of the same garment with another solver. Both get the same commands
/// and advance frame by frame together, at the speed of the slower one. If one stops, the other continues. Each has the
/// same states as alone.
class SimulationPair {
 public:
  /// Starts with one garment. Throws InputError if it cannot be loaded.
  explicit SimulationPair(const SceneWithBodies& scene);

  void apply(const SimulationCommand& command);

  bool wants_to_advance() const { return first_.wants_to_advance() || (second_ && second_->wants_to_advance()); }
  // Speed and frame time are the same for both simulations.
  double speed() const { return first_.speed(); }
  double frame_time_s() const { return first_.frame_time_s(); }
  std::uint64_t advances() const { return first_.advances(); }
  std::uint64_t state_hash() const { return first_.state_hash(); }

  /// Computes one frame of each, as LiveSimulation does.
  void advance(const std::function<void()>& poll = {});

  /// Returns the present state, which includes the second garment's. Each call increases the serial number by 1.
  SnapshotPtr take_snapshot();

 private:
  void compare(const Compare& asked);
  void begin_second();
  void pass_on(const SimulationCommand& command);
  void pass_on_notices();
  ChangeSettings own_settings() const;

  LiveSimulation first_;
  std::optional<sim::SolverKind> kind_;  ///< solver of the second simulation
  std::optional<LiveSimulation> second_;
  ChangeSettings settings_;        ///< present settings
  std::uint64_t told_notice_ = 0;  ///< number of the second simulation's last notice that was passed on
};

/// Runs the window's simulation. In each of its frames the window calls begin_frame, then post.
class SimulationHost {
 public:
  enum class Runs {
    /// Runs on a thread of its own, in real time if it is fast enough. The window's frame rate influences the states
    /// only through the moments at which commands arrive, which `post` returns.
    by_itself,
    /// Runs on the caller's thread, by the window's clock or at a recorded pace: the same session gives the same
    /// states.
    when_asked
  };
  /// Throws InputError if the garment cannot be loaded.
  SimulationHost(const SceneWithBodies& scene, Runs runs);
  /// Calls end().
  ~SimulationHost() { end(); }

  /// Returns the snapshot that this frame of the window shows. A simulation that runs by itself ignores both arguments;
  /// otherwise throws InputError if `pace` is not possible after the frames before it.
  SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace);
  /// Passes commands on, to be done before the next simulated frame begins. Returns the number of frames that have
  /// begun so far.
  std::uint64_t post(std::vector<SimulationCommand> commands);
  /// Returns the snapshot of a frame in the ten seconds before `now`, or of the nearest kept frame.
  SnapshotPtr past_frame(const SnapshotPtr& now, int frame);
  /// Returns the hash of the newest state. Waits for the frame that is being computed.
  std::uint64_t state_hash();

  /// Stops the simulation. Waits for posted commands, and at most half a second for the frame that is being computed,
  /// which is then abandoned.
  void end();
  bool gave_up_frame() const { return gives_up_; }  ///< valid after `end`
  /// Returns the simulated time given up since the last call because other work used the processors; 0 if the
  /// simulation is too slow by itself.
  double take_given_up_ms();
  /// Returns the CPU time of the last frame.
  double worked_ms();
  std::uint64_t advances() const { return simulation_.advances(); }  ///< valid after `end`

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void wait_until_due(std::unique_lock<std::mutex>& lock);
  void perform_posted(std::unique_lock<std::mutex>& lock);
  void advance(std::unique_lock<std::mutex>& lock);
  void advance_as_asked();
  void follow_clock(double elapsed_s);
  void follow(const Pace& pace);

  const Runs runs_;
  SimulationPair simulation_;  ///< used only by the thread while `busy_`
  std::mutex mutex_;
  std::condition_variable changed_;
  Timeline timeline_;
  std::deque<std::vector<SimulationCommand>> posted_;  ///< one entry for each frame of the window
  std::uint64_t begun_ = 0;
  double owed_s_ = 0.0;  ///< simulated time that is due, if the simulation runs when asked
  Clock::duration given_up_{};
  double worked_ms_ = 0.0;  ///< CPU time of the last frame
  bool busy_ = false;
  bool is_in_frame_ = false;
  bool ending_ = false;
  std::atomic<bool> gives_up_ = false;
  Clock::time_point due_;
  std::thread thread_;
};

}  // namespace taut::app
