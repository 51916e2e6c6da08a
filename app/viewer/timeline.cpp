#include "app/viewer/timeline.hpp"

#include <algorithm>
#include <utility>

namespace taut::app {
namespace {

constexpr std::size_t most_bytes = 256U << 20U;
constexpr int fewest_frames = 30;
// The window may be so many frames behind the newest snapshot and still reach as far back as it promises.
constexpr int slack_frames = 120;
// While paused every change of a setting makes a snapshot of the same frame.
constexpr std::size_t most_snapshots = 4096;

int reach_frames(const Snapshot& newest) {
  const double rate_hz = newest.loaded->scene.simulation.frame_rate_hz;
  const auto by_time = static_cast<int>(std::min(Timeline::span_s * rate_hz, 1e6));
  const std::size_t frame_bytes = std::max<std::size_t>(1, newest.positions->size() * sizeof(sim::Vec3));
  const auto by_memory = static_cast<int>(std::min<std::size_t>(most_bytes / frame_bytes, 1000000));
  return std::max(fewest_frames, std::min(by_time, by_memory));
}

bool belong_together(const Snapshot& older, const Snapshot& newer) {
  return older.loaded == newer.loaded && older.record.frame <= newer.record.frame;
}

}  // namespace

int first_frame_in_reach(const Snapshot& newest) {
  return std::max(0, newest.record.frame - reach_frames(newest));
}

void Timeline::add(SnapshotPtr snapshot) {
  if (!kept_.empty() && !belong_together(*kept_.back(), *snapshot)) {
    kept_.clear();
  }
  kept_.push_back(std::move(snapshot));
  forget_what_is_past();
}

void Timeline::forget_what_is_past() {
  const int first = first_frame_in_reach(*newest()) - slack_frames;
  while (kept_.size() > most_snapshots || (kept_.size() > 1 && kept_.front()->record.frame < first)) {
    kept_.pop_front();
  }
}

const SnapshotPtr& Timeline::with_serial(std::uint64_t serial) const {
  const auto found =
      std::lower_bound(kept_.begin(), kept_.end(), serial,
                       [](const SnapshotPtr& kept, std::uint64_t wanted) { return kept->serial < wanted; });
  return found == kept_.end() ? kept_.back() : *found;
}

const SnapshotPtr& Timeline::of_frame(int frame) const {
  const auto after =
      std::upper_bound(kept_.begin(), kept_.end(), frame,
                       [](int wanted, const SnapshotPtr& kept) { return wanted < kept->record.frame; });
  return after == kept_.begin() ? kept_.front() : *std::prev(after);
}

}  // namespace taut::app
