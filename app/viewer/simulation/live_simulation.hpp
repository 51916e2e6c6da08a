#pragma once

#include "app/viewer/simulation/simulation_command.hpp"
#include "app/viewer/simulation/snapshot.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

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
  void perform(const ReleasePins& release);
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
  void set_pins(std::vector<sim::Index> pins);
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
