#include "app/viewer/simulation/snapshot.hpp"

namespace taut::app {
namespace {

constexpr std::size_t most_bytes = 288U << 20U;
constexpr int fewest_frames = 30;
// The window may be so many snapshots behind the newest and still look back as far as it promises.
constexpr int slack = 120;
constexpr int look_after = 16;
// A checkpoint while cloth moves: three arrays of positions, and the correction of the last frame.
constexpr std::size_t vertex_bytes = 3 * sizeof(sim::Vec3) + 3 * sizeof(float);

int reach_frames(const Snapshot& newest) {
  const double rate_hz = newest.loaded->scene.simulation.frame_rate_hz;
  const auto by_time = static_cast<int>(std::min(Timeline::span_s * rate_hz, 1e6));
  const std::size_t garments = newest.compared ? 2 : 1;
  const std::size_t frame_bytes = std::max<std::size_t>(1, garments * newest.positions().size() * vertex_bytes);
  const auto by_memory = static_cast<int>(std::min<std::size_t>(most_bytes / frame_bytes, 1000000));
  return std::max(fewest_frames, std::min(by_time, by_memory));
}

// Goes from a snapshot back through what led to it.
class PastWalk {
 public:
  explicit PastWalk(const Snapshot& now) : loaded_(now.loaded), frame_(now.record.frame) {}

  // Whether an older snapshot led to those before; of one frame, the last that it had.
  bool takes(const Snapshot& older) {
    if (older.loaded != loaded_ || older.record.frame >= frame_) return false;
    frame_ = older.record.frame;
    return true;
  }

 private:
  std::shared_ptr<const LoadedScene> loaded_;
  int frame_;
};

}  // namespace

bool has_stopped(const Snapshot& snapshot) {
  return snapshot.stopped && (!snapshot.compared || snapshot.compared->stopped);
}

bool moves(const Snapshot& snapshot) {
  return (!snapshot.stopped && !snapshot.record.asleep) || (snapshot.compared && moves(*snapshot.compared));
}

sim::Simulation gone_on_from(const Snapshot& past, const sim::SimulationSettings& settings,
                             const sim::Material& material, const sim::Surroundings& surroundings) {
  sim::Simulation simulation(past.garment, *past.pins, past.settings, past.surroundings);
  simulation.restore(*past.checkpoint);
  simulation.set_settings(settings);
  if (material != past.garment->material) simulation.set_material(material);
  simulation.set_surroundings(surroundings);
  return simulation;
}

int first_frame_in_reach(const Snapshot& newest) { return std::max(0, newest.record.frame - reach_frames(newest)); }

void Timeline::add(SnapshotPtr snapshot) {
  kept_.push_back(std::move(snapshot));
  if (++added_ >= look_after) {
    added_ = 0;
    forget_what_is_past();
  }
}

// Of what is older than the slack, only the past of the first one younger is of use.
void Timeline::forget_what_is_past() {
  if (kept_.size() <= slack) return;
  const auto young = kept_.end() - slack;
  const int first = first_frame_in_reach(**young) - slack;
  PastWalk walk(**young);
  std::deque<SnapshotPtr> useful(young, kept_.end());
  for (auto older = std::make_reverse_iterator(young); older != kept_.rend(); ++older) {
    if (walk.takes(**older) && (*older)->record.frame >= first) useful.push_front(*older);
  }
  kept_ = std::move(useful);
}

const SnapshotPtr& Timeline::with_serial(std::uint64_t serial) const {
  const auto found = std::ranges::lower_bound(kept_, serial, {}, &Snapshot::serial);
  return found == kept_.end() ? kept_.back() : *found;
}

SnapshotPtr Timeline::of_frame(const SnapshotPtr& now, int frame) const {
  SnapshotPtr nearest = now;
  PastWalk walk(*now);
  const auto end = std::ranges::upper_bound(kept_, now->serial, {}, &Snapshot::serial);
  for (auto older = std::make_reverse_iterator(end); older != kept_.rend() && nearest->record.frame > frame; ++older) {
    if (walk.takes(**older)) nearest = *older;
  }
  return nearest;
}

}  // namespace taut::app
