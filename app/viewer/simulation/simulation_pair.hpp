#pragma once

#include <optional>

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

  bool wants_to_advance() const {
    return first_.wants_to_advance() || (second_ && second_->wants_to_advance());
  }
  // Of the first.
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

}  // namespace taut::app
