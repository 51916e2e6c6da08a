#pragma once

#include "app/drawing/garment_surface.hpp"
#include "app/output/frame_record.hpp"

namespace taut::app {

/// A scene with its garment, as it was loaded.
struct LoadedScene : GarmentInScene {
  DrawnScene scene;
  DrawnColours drawn_colours;
  std::uint64_t generation = 0;  ///< a new number for each load
};

/// A message to the user.
struct Notice {
  std::string text;
  bool is_error = false;
  std::uint64_t number = 0;  ///< larger for each new notice; 0: none yet
};

/// Everything the window may know of the simulation at one moment. Never changes once made, so both threads
/// read it freely.
struct Snapshot {
  std::uint64_t serial = 0;    ///< rises by 1 from snapshot to snapshot
  std::uint64_t advances = 0;  ///< simulated frames since the window was opened
  std::shared_ptr<const LoadedScene> loaded;
  std::shared_ptr<const std::vector<sim::Index>> pins;
  std::shared_ptr<const sim::Checkpoint> checkpoint;
  // In force then: what the checkpoint goes on with. A hand's pull is among the forces.
  std::shared_ptr<const sim::Garment> garment;
  sim::SimulationSettings settings;
  sim::Surroundings surroundings;
  FrameRecord record;
  /// The latest, oldest first; never null. A window that missed a snapshot must not miss what it said.
  std::shared_ptr<const std::vector<Notice>> notices = std::make_shared<const std::vector<Notice>>();
  std::shared_ptr<const Snapshot> compared;  ///< the second garment, at the same time; null: none
  bool paused = false;
  bool stopped = false;   ///< diverged or blocked: nothing moves until a reset
  bool pristine = false;  ///< since the start or the last reset no setting changed and nobody pulled

  /// Positions that are drawn: in metres, per vertex.
  const std::vector<sim::Vec3>& positions() const { return checkpoint->state.current; }
};

/// Whether no garment goes on.
bool has_stopped(const Snapshot& snapshot);
/// Whether one of the garments goes on and is not at rest, unless it is paused.
bool moves(const Snapshot& snapshot);

/// The simulation as it was, with the same bits to come while nothing is changed, but with the settings,
/// the material and the surroundings of now. Throws as sim::Simulation does.
sim::Simulation gone_on_from(const Snapshot& past, const sim::SimulationSettings& settings,
                             const sim::Material& material, const sim::Surroundings& surroundings);

using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// The last snapshots, of ten simulated seconds or as many as memory allows. The past of a snapshot
/// depends on that snapshot alone, not on what has been added since: the window may be some frames behind.
class Timeline {
 public:
  void add(SnapshotPtr snapshot);

  const SnapshotPtr& newest() const { return kept_.back(); }
  /// The snapshot with this serial number, or the nearest one that is kept.
  const SnapshotPtr& with_serial(std::uint64_t serial) const;
  /// The last snapshot of a frame in the past of `now`, or of the nearest frame that is kept; `now` itself
  /// where it has no past. Frames that were gone back from, before a reset or of another garment, are not its past.
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
