#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/viewer/session/session.hpp"
#include "app/viewer/simulation/live_simulation.hpp"

namespace taut::app {

/// A live simulation, and beside it a second one of the same garment by another solver if one is asked for.
/// Both get the same commands and advance frame by frame together; the slower one holds both back. One that
/// has stopped does not stop the other. The states are those of each solver alone.
class SimulationPair {
 public:
  /// One garment. Throws InputError if it cannot be loaded.
  explicit SimulationPair(const DrawnScene& scene);

  void apply(const SimulationCommand& command);

  bool wants_to_advance() const { return first_.wants_to_advance() || (second_ && second_->wants_to_advance()); }
  // Both simulations have the speed and the frame time of the first.
  double speed() const { return first_.speed(); }
  double frame_time_s() const { return first_.frame_time_s(); }
  std::uint64_t advances() const { return first_.advances(); }
  std::uint64_t state_hash() const { return first_.state_hash(); }

  /// Computes one frame of each, as LiveSimulation does.
  void advance(const std::function<void()>& poll = {});

  /// The state of now; the second garment's is within. Each call returns a serial number larger by 1.
  SnapshotPtr take_snapshot();

 private:
  void compare(const Compare& asked);
  void begin_second();
  void pass_on(const SimulationCommand& command);
  void pass_on_notices();
  ChangeSettings own_settings() const;

  LiveSimulation first_;
  std::optional<sim::SolverKind> kind_;  ///< of the second
  std::optional<LiveSimulation> second_;
  ChangeSettings settings_;  ///< in force
  bool paused_ = false;
  std::uint64_t told_notice_ = 0;  ///< of the second
};

/// Runs the window's simulation. In each of its frames the window calls begin_frame, then post.
class SimulationHost {
 public:
  enum class Runs {
    /// On a thread of its own, in step with the clock where it can keep up. How fast the window draws has no
    /// influence on the states but through the moments its commands come in, which `post` tells.
    by_itself,
    /// On the caller's thread, by the window's own clock or as it was recorded: the same session gives the
    /// same states.
    when_asked
  };
  /// Throws InputError if the garment cannot be loaded.
  SimulationHost(const DrawnScene& scene, Runs runs);
  /// As end().
  ~SimulationHost() { end(); }
  SimulationHost(const SimulationHost&) = delete;
  SimulationHost& operator=(const SimulationHost&) = delete;

  /// The snapshot that this frame of the window has to show. One that runs by itself needs neither time nor
  /// pace; else throws InputError if `pace` is not possible after the frames before it.
  SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace);
  /// Hands commands over; they are done before the next simulated frame begins. Returns how many have begun
  /// by now.
  std::uint64_t post(std::vector<SimulationCommand> commands);
  /// The snapshot of a frame in the ten seconds before `now`, or of the nearest one that is kept.
  SnapshotPtr past_frame(const SnapshotPtr& now, int frame);
  /// Hash of the newest state. Waits for a simulated frame that is being computed.
  std::uint64_t state_hash();

  /// Stops the simulation. Waits for posted commands, and half a second for the frame that is being computed,
  /// which is given up then.
  void end();
  bool gave_up_frame() const { return gives_up_; }  ///< after `end`
  /// Simulated time that was given up since the last call because other work had the processors; 0 where
  /// the simulation could not have kept up anyway.
  double take_given_up_ms();
  /// Processor time of the last frame.
  double worked_ms();
  std::uint64_t advances() const { return simulation_.advances(); }  ///< after `end`

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
  double owed_s_ = 0.0;  ///< simulated time that is due when asked
  Clock::duration given_up_{};
  double worked_ms_ = 0.0;  ///< processor time of the last frame
  bool busy_ = false;
  bool is_in_frame_ = false;
  bool ending_ = false;
  std::atomic<bool> gives_up_ = false;
  Clock::time_point due_;
  std::thread thread_;
};

}  // namespace taut::app
