#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/simulation/simulation_pair.hpp"

namespace taut::app {

/// Simulates on a thread of its own, in step with the clock where it can keep up. How fast the window draws
/// has no influence on the states but through the moments its commands come in, which `post` tells.
class SimulationThread : public SimulationHost {
 public:
  /// Throws InputError if the garment cannot be loaded.
  explicit SimulationThread(const DrawnScene& scene);
  /// As end().
  ~SimulationThread() override;

  SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace) override;
  std::uint64_t post(std::vector<SimulationCommand> commands) override;
  SnapshotPtr past_frame(const SnapshotPtr& now, int frame) override;
  std::uint64_t state_hash() override;

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

  SimulationPair simulation_;  ///< used only by the thread while `busy_`
  std::mutex mutex_;
  std::condition_variable changed_;
  Timeline timeline_;
  std::deque<std::vector<SimulationCommand>> posted_;  ///< one entry for each frame of the window
  std::uint64_t begun_ = 0;
  Clock::duration given_up_{};
  Clock::duration worked_{};  ///< processor time of the last frame
  bool busy_ = false;
  bool is_in_frame_ = false;
  bool ending_ = false;
  std::atomic<bool> gives_up_ = false;
  Clock::time_point due_;
  std::thread thread_;
};

}  // namespace taut::app
