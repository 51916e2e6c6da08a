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

/// One vertex of a grip.
struct GripVertex {
  sim::Index vertex = 0;
  double share = 0.0;                    ///< fraction of the pull; all shares add up to 1
  sim::Vec3 offset_m = {0.0, 0.0, 0.0};  ///< from the vertex that was taken hold of
};

/// A hand that holds some square centimetres of cloth. A single vertex would be pulled out to a point.
struct Grip {
  std::vector<GripVertex> vertices;
  sim::Vec3 target_m = {0.0, 0.0, 0.0};  ///< where the vertex that was taken hold of should go
};

/// A grip around a vertex. Shares shrink with the distance along edges. `positions`: metres, per vertex.
Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex);

/// The hand at a point, as springs to vertices. They hold the whole garment's weight with a stretch of
/// millimetres and give up at some times that weight.
std::vector<sim::HeldVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m, const sim::Garment& garment);

/// Position of the hand after `time_s`, on its way to the target. It is no faster than an arm.
sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s);

// Requests of the window to the simulation; done between two simulated frames, in the order it was asked.

/// Replaces scene and garment.
struct LoadScene {
  std::shared_ptr<const DrawnScene> scene;
};
/// All that can change while a garment moves. Artificial forces are the scene's own; a hand's come on top.
struct ChangeSettings {
  ChangeSettings() = default;
  /// The settings of the scene.
  explicit ChangeSettings(const Scene& scene)
      : simulation(scene.simulation), surroundings(scene.surroundings), material(scene.material) {}

  bool operator==(const ChangeSettings&) const = default;

  RunSettings simulation;
  sim::Surroundings surroundings;
  sim::Material material;
};
/// Pins the vertex where it is, or removes its pin.
struct TogglePin {
  sim::Index vertex = 0;
};
/// Takes hold of cloth, or moves the hand that holds it.
struct TakeHold {
  Grip grip;
};
/// Lets go of the cloth.
struct LetGo {};
/// Returns to the start of the scene, with the scene's pins and the present settings.
struct Reset {};
/// Returns to an earlier frame, with its pins and the present settings. Later frames are dropped.
struct GoBack {
  SnapshotPtr to;
};
/// Pauses the simulation or lets it continue.
struct SetPaused {
  bool paused = false;
};
/// Computes one frame while paused.
struct StepOnce {};
/// Sets the simulated seconds per second of real time.
struct SetSpeed {
  double factor = 1.0;
};
/// Simulates a second garment beside the first, by another solver, or none any more. Both begin anew.
struct Compare {
  std::optional<sim::SolverKind> with;
};

using SimulationCommand = std::variant<LoadScene, ChangeSettings, TogglePin, TakeHold, LetGo, Reset, GoBack, SetPaused,
                                       StepOnce, SetSpeed, Compare>;

/// A simulation that takes commands between its frames and goes on whatever comes: what a command or a frame
/// cannot do becomes a notice. Its states depend on the order of commands and advances alone, never on a
/// clock.
class LiveSimulation {
 public:
  /// Throws InputError if the garment cannot be loaded.
  explicit LiveSimulation(const DrawnScene& scene);

  /// Of what another one has loaded, beside which it runs.
  explicit LiveSimulation(std::shared_ptr<const LoadedScene> loaded);

  void apply(const SimulationCommand& command);

  /// Whether the next frame is wanted: the simulation is not paused, or a single step was asked for.
  bool wants_to_advance() const { return !now_.stopped && (!now_.paused || steps_left_ > 0); }
  double speed() const { return speed_; }
  double frame_time_s() const { return simulation_->frame_time_s(); }
  std::uint64_t advances() const { return now_.advances; }

  /// Computes one frame. Does nothing after the simulation has diverged or was blocked. Throws Interrupted
  /// where `poll`, which is called often, does; the cloth is then as it was.
  void advance(const std::function<void()>& poll = {});

  /// The state of now, with that of a garment beside it. Each call returns a serial number larger by 1.
  SnapshotPtr take_snapshot(SnapshotPtr compared = nullptr);

  const std::shared_ptr<const LoadedScene>& loaded() const { return now_.loaded; }
  bool is_stopped() const { return now_.stopped; }
  const std::vector<Notice>& notices() const { return *now_.notices; }
  void tell(const std::string& text, bool is_error);

  std::uint64_t state_hash() const { return sim::hash(simulation_->state()); }

 private:
  void perform(const LoadScene& load);
  void perform(const ChangeSettings& change);
  void perform(const TogglePin& toggle);
  void perform(const TakeHold& hold);
  void perform(const LetGo&);
  void perform(const Reset&);
  void perform(const GoBack& back);
  void perform(const SetPaused& pause);
  void perform(const StepOnce&) { steps_left_ += now_.paused ? 1 : 0; }
  void perform(const SetSpeed& speed) { speed_ = speed.factor; }
  void perform(const Compare&) {}  // of a SimulationPair

  void start(std::shared_ptr<const LoadedScene> loaded);
  void untangle(const RunSettings& simulation);
  void note_shape();
  void tell_of_start();
  void stop(const std::string& reason);
  void pull();

  Snapshot now_;  ///< but for what the simulation knows itself
  std::optional<sim::Simulation> simulation_;
  sim::Surroundings surroundings_;  ///< without the hand
  std::optional<Grip> grip_;
  sim::Vec3 hand_m_ = {0.0, 0.0, 0.0};                          ///< on its way to the grip's target
  const char* way_on_ = "R or any other setting starts again";  ///< after it has stopped
  int start_frame_ = 0;                                         ///< the frame that the scene begins with
  int frame_ = 0;
  int steps_left_ = 0;
  double speed_ = 1.0;
};

}  // namespace taut::app
