#pragma once

#include "app/drawing/garment_colours.hpp"
#include "app/drawing/garment_surface.hpp"
#include "app/garments/dressing/dressing.hpp"
#include "app/runs/frame_record.hpp"

namespace taut::app {

/// A scene with its bodies.
struct SceneWithBodies {
  /// Takes a scene whose bodies have no meshes of files.
  SceneWithBodies(DrawnScene asked) : scene(std::move(asked)), bodies{named_bodies(scene)} {}
  SceneWithBodies(DrawnScene asked, LoadedBodies loaded) : scene(std::move(asked)), bodies(std::move(loaded)) {}

  DrawnScene scene;
  LoadedBodies bodies;
};

/// A scene with its loaded garment and bodies.
struct LoadedScene : GarmentInScene, SceneWithBodies {
  DrawnColours drawn_colours;
  std::uint64_t generation = 0;  ///< number of the load
};

/// A message to the user.
struct Notice {
  std::string text;
  bool is_error = false;
  std::uint64_t number = 0;  ///< larger for each new notice; 0: none yet
};

/// The simulation's state for the window at one moment. It never changes once made, so both threads may read it.
struct Snapshot {
  std::uint64_t serial = 0;    ///< increases by 1 from snapshot to snapshot
  std::uint64_t advances = 0;  ///< simulated frames since the window was opened
  std::shared_ptr<const LoadedScene> loaded;
  std::shared_ptr<const std::vector<sim::Index>> pins;
  std::shared_ptr<const sim::Checkpoint> checkpoint;
  // Garment, settings and surroundings that the checkpoint continues with. The forces include the hand's pull.
  std::shared_ptr<const sim::Garment> garment;
  sim::SimulationSettings settings;
  sim::Surroundings surroundings;
  FrameRecord record;
  /// Latest notices, oldest first; never null. A window that missed a snapshot still gets its notices.
  std::shared_ptr<const std::vector<Notice>> notices = std::make_shared<const std::vector<Notice>>();
  std::shared_ptr<const Snapshot> compared;  ///< second garment at the same time; null: none
  bool paused = false;
  bool stopped = false;   ///< diverged or blocked; nothing moves until a reset
  bool pristine = false;  ///< no setting changed and nobody pulled since the start or the last reset

  /// Returns the drawn positions in metres, per vertex.
  const std::vector<sim::Vec3>& positions() const { return checkpoint->state.current; }
};

/// Returns true if all garments have stopped.
bool has_stopped(const Snapshot& snapshot);
/// Returns true if a garment neither has stopped nor sleeps.
bool moves(const Snapshot& snapshot);

/// Returns the simulation of a past snapshot with the present settings, material and surroundings. Without changes it
/// continues with the same bits. Throws as sim::Simulation does.
sim::Simulation continue_from(const Snapshot& past, const sim::SimulationSettings& settings,
                              const sim::Material& material, const sim::Surroundings& surroundings);

using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// The snapshots of the last ten simulated seconds, or as many as memory allows. The past of a snapshot does not depend
/// on later snapshots, because the window may be some frames behind.
class Timeline {
 public:
  void add(SnapshotPtr snapshot);

  const SnapshotPtr& newest() const { return kept_.back(); }
  /// Returns the snapshot with this serial number, or else the next one that is kept.
  const SnapshotPtr& with_serial(std::uint64_t serial) const;
  /// Returns the last snapshot of a frame in the past of `now`, or of the nearest kept frame; `now` itself if it has no
  /// past. Frames that a rewind or a reset dropped, and frames of another garment, do not belong to the past.
  SnapshotPtr of_frame(const SnapshotPtr& now, int frame) const;

  std::size_t count() const { return kept_.size(); }

  static constexpr double span_s = 10.0;

 private:
  void drop_old_snapshots();

  std::deque<SnapshotPtr> kept_;  ///< ordered by serial number
  int added_ = 0;                 ///< number since snapshots were last dropped
};

/// Returns the first frame that `newest` can go back to. It does not depend on what a timeline keeps.
int first_frame_in_reach(const Snapshot& newest);

/// A vertex of a grip.
struct GripVertex {
  sim::Index vertex = 0;
  double share = 0.0;                    ///< fraction of the pull; all shares add up to 1
  sim::Vec3 offset_m = {0.0, 0.0, 0.0};  ///< offset from the grabbed vertex
};

/// A hand that holds some square centimetres of cloth. A single vertex would be pulled out to a point.
struct Grip {
  std::vector<GripVertex> vertices;
  sim::Vec3 target_m = {0.0, 0.0, 0.0};  ///< target position of the grabbed vertex
};

/// Returns a grip around a vertex. Shares decrease with the distance along edges. `positions`: metres, per vertex.
Grip take_grip(const sim::Garment& garment, std::span<const sim::Vec3> positions, sim::Index vertex);

/// Returns the hand at a point as springs to vertices. They hold the whole garment's weight with a stretch of
/// millimetres, and their force is limited to a few times that weight.
std::vector<sim::GrabbedVertex> held_vertices(const Grip& grip, const sim::Vec3& hand_m, const sim::Garment& garment);

/// Returns the position of the hand after `time_s` on its way to the target, at most as fast as an arm.
sim::Vec3 moved_hand(const sim::Vec3& hand_m, const sim::Vec3& target_m, double time_s);

// Requests of the window to the simulation. They are done in order, between two simulated frames.

/// Replaces scene and garment.
struct LoadScene {
  std::shared_ptr<const SceneWithBodies> scene;
};
/// Changes everything that can change while a garment moves. Artificial forces are the scene's; a hand's forces are
/// added.
struct ChangeSettings {
  ChangeSettings() = default;
  /// Takes the settings of the scene.
  explicit ChangeSettings(const Scene& scene)
      : simulation(scene.simulation), surroundings(scene.surroundings), material(scene.material) {}

  bool operator==(const ChangeSettings&) const = default;

  RunSettings simulation;
  sim::Surroundings surroundings;
  sim::Material material;
};
/// Pins the vertex at its position, or removes its pin.
struct TogglePin {
  sim::Index vertex = 0;
};
/// Grabs cloth, or moves the hand that holds it.
struct TakeHold {
  Grip grip;
};
/// Releases the cloth.
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
/// Simulates a second garment beside the first with another solver, or removes it. Both start again.
struct Compare {
  std::optional<sim::SolverKind> with;
};

using SimulationCommand = std::variant<LoadScene, ChangeSettings, TogglePin, TakeHold, LetGo, Reset, GoBack, SetPaused,
                                       StepOnce, SetSpeed, Compare>;

/// A simulation that takes commands between its frames and continues after errors: a command or frame that fails
/// becomes a notice. Its states depend only on the order of commands and advances, never on a clock.
class LiveSimulation {
 public:
  /// Throws InputError if the garment cannot be loaded.
  explicit LiveSimulation(const SceneWithBodies& scene);

  /// Simulates the garment of another simulation beside it.
  explicit LiveSimulation(std::shared_ptr<const LoadedScene> loaded);

  void apply(const SimulationCommand& command);

  /// Returns true if the next frame is due: the simulation is not paused, or a single step was requested.
  bool wants_to_advance() const { return !now_.stopped && (!now_.paused || steps_left_ > 0); }
  double speed() const { return speed_; }
  double frame_time_s() const { return simulation_->frame_time_s(); }
  std::uint64_t advances() const { return now_.advances; }

  /// Computes one frame. Does nothing after the simulation has diverged or was blocked. Calls `poll` often; if it
  /// throws Interrupted, so does this function, and the cloth does not change.
  void advance(const std::function<void()>& poll = {});

  /// Returns the present state, together with a second garment's. Each call increases the serial number by 1.
  SnapshotPtr take_snapshot(SnapshotPtr compared = nullptr);

  const std::shared_ptr<const LoadedScene>& loaded() const { return now_.loaded; }
  bool is_stopped() const { return now_.stopped; }
  bool is_paused() const { return now_.paused; }
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
  void perform(const Compare&) {}  // done by SimulationPair

  void start(std::shared_ptr<const LoadedScene> loaded);
  /// Shows the simulated mesh from now on if the model that follows is stretched too much.
  void show_simulated_if_torn();
  void untangle(const RunSettings& simulation);
  void note_shape();
  void tell_of_start();
  void stop(const std::string& reason);
  void pull();

  Snapshot now_;  ///< without the state that simulation_ has
  std::optional<sim::Simulation> simulation_;
  sim::Surroundings surroundings_;  ///< without the hand
  std::optional<Grip> grip_;
  sim::Vec3 hand_m_ = {0.0, 0.0, 0.0};                                ///< hand's position, moving to the grip's target
  const char* restart_hint_ = "R or any other setting starts again";  ///< hint after the simulation has stopped
  int start_frame_ = 0;                                               ///< first frame of the scene
  int frame_ = 0;
  int steps_left_ = 0;
  double speed_ = 1.0;
};

}  // namespace taut::app
