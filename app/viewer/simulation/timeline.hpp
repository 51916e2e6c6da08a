#pragma once

#include <deque>

#include "app/viewer/simulation/snapshot.hpp"

namespace taut::app {

/// The last snapshots, of ten simulated seconds or as many as memory allows. What a snapshot can look back on
/// depends on that snapshot alone, not on what has been added since: the window may be some frames behind.
class Timeline {
 public:
  void add(SnapshotPtr snapshot);

  const SnapshotPtr& newest() const { return kept_.back(); }
  /// The snapshot with this serial number, or the nearest one that is kept.
  const SnapshotPtr& with_serial(std::uint64_t serial) const;
  /// The last snapshot of a frame in the past of `now`, or of the nearest frame that is kept; `now` itself
  /// where it has no past. What was gone back from, before a reset or of another garment, is not its past.
  SnapshotPtr of_frame(const SnapshotPtr& now, int frame) const;

  std::size_t count() const { return kept_.size(); }

  static constexpr double span_s = 10.0;

 private:
  void forget_what_is_past();

  std::deque<SnapshotPtr> kept_;  ///< by serial number
  int added_ = 0;                 ///< since snapshots were last dropped
};

/// The first frame that can be gone back to from `newest`; the same whatever a timeline happens to keep
/// beyond.
int first_frame_in_reach(const Snapshot& newest);

}  // namespace taut::app
