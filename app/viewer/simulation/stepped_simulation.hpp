#pragma once

#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/simulation/simulation_pair.hpp"

namespace taut::app {

/// Simulates on the caller's thread, by the window's own clock or as it was recorded: the same session gives
/// the same states.
class SteppedSimulation : public SimulationHost {
 public:
  /// Throws InputError if the garment cannot be loaded.
  explicit SteppedSimulation(const DrawnScene& scene);

  /// Throws InputError if `pace` is not possible after the frames before it.
  SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace) override;
  std::uint64_t post(std::vector<SimulationCommand> commands) override;
  SnapshotPtr past_frame(const SnapshotPtr& now, int frame) override {
    return timeline_.of_frame(now, frame);
  }
  std::uint64_t state_hash() override { return simulation_.state_hash(); }

 private:
  void advance();
  void follow_clock(double elapsed_s);

  SimulationPair simulation_;
  Timeline timeline_;
  double owed_s_ = 0.0;  ///< simulated time that is due
};

}  // namespace taut::app
