#pragma once

#include <deque>

#include "app/viewer/snapshot.hpp"

namespace taut::app {

/// The last snapshots, of ten simulated seconds or as many as memory allows.
class Timeline {
 public:
  /// Snapshots of an older garment or from before a reset are forgotten, the newest excepted.
  void add(SnapshotPtr snapshot);

  bool empty() const { return kept_.empty(); }
  const SnapshotPtr& newest() const { return kept_.back(); }
  /// The snapshot with this serial, or the one kept that is nearest to it.
  const SnapshotPtr& with_serial(std::uint64_t serial) const;
  /// The last snapshot of a frame, or of the nearest frame that is kept.
  const SnapshotPtr& of_frame(int frame) const;

  static constexpr double span_s = 10.0;

 private:
  void forget_what_is_past();

  std::deque<SnapshotPtr> kept_;
};

/// The first frame that can be gone back to from `newest`; the same whatever a timeline happens to keep
/// beyond.
int first_frame_in_reach(const Snapshot& newest);

}  // namespace taut::app
