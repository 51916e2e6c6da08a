#pragma once

#include <optional>
#include <vector>

#include "app/viewer/session/session.hpp"
#include "app/viewer/simulation/simulation_command.hpp"
#include "app/viewer/simulation/snapshot.hpp"
#include "app/viewer/simulation/timeline.hpp"

namespace taut::app {

/// Runs the window's simulation. In each of its frames the window calls begin_frame, then post.
class SimulationHost {
 public:
  virtual ~SimulationHost() = default;

  /// The snapshot that this frame of the window has to show.
  virtual SnapshotPtr begin_frame(double elapsed_s, const std::optional<Pace>& pace) = 0;

  /// Hands commands over; they are done before the next simulated frame begins. Returns how many have begun
  /// by now.
  virtual std::uint64_t post(std::vector<SimulationCommand> commands) = 0;

  /// The snapshot of a frame in the ten seconds before `now`, or of the nearest one that is kept.
  virtual SnapshotPtr past_frame(const SnapshotPtr& now, int frame) = 0;

  /// Hash of the newest state. Waits for a simulated frame that is being computed.
  virtual std::uint64_t state_hash() = 0;
};

}  // namespace taut::app
