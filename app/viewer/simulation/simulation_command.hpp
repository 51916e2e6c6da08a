#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/simulation/grip.hpp"
#include "app/viewer/simulation/snapshot.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

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
/// Removes the pins of one side: those in the outer third of the width of all pins.
struct ReleasePins {
  bool right = false;
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

using SimulationCommand = std::variant<LoadScene, ChangeSettings, TogglePin, ReleasePins, TakeHold, LetGo,
                                       Reset, GoBack, SetPaused, StepOnce, SetSpeed, Compare>;

}  // namespace taut::app
