#pragma once

#include <optional>
#include <vector>

#include "app/viewer/session/session.hpp"
#include "app/viewer/simulation/simulation_command.hpp"
#include "app/viewer/simulation/snapshot.hpp"
#include "app/viewer/simulation/timeline.hpp"

namespace taut::app {

/// Where the window's simulation runs. The window asks, once a frame: begin_frame, then post.
class SimulationHost {
 public:
  virtual ~SimulationHost() = default;

  /// What the window's frame is to show.
  virtual SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace) = 0;

  /// Hands commands over; they are done before the next simulated frame begins. Returns how many have begun
  /// by now.
  virtual std::uint64_t post(std::vector<SimulationCommand> commands) = 0;

  /// A frame of the last ten seconds before `now`, or the nearest that is still kept.
  virtual SnapshotPtr past_frame(const SnapshotPtr& now, int frame) = 0;

  /// Of the newest state; waits for a frame that is under way.
  virtual std::uint64_t state_hash() = 0;
};

}  // namespace taut::app
