#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/simulation/grip.hpp"
#include "app/viewer/simulation/snapshot.hpp"
#include "sim/surroundings.hpp"

namespace taut::app {

// What the window asks of the simulation; done between two simulated frames, in the order it was asked.

struct LoadScene {
  std::shared_ptr<const DrawnScene> scene;
};
/// All that can change while a garment moves. Artificial forces are the scene's own; a hand's come on top.
struct ChangeSettings {
  ChangeSettings() = default;
  /// To those of the scene.
  explicit ChangeSettings(const Scene& scene)
      : simulation(scene.simulation),
        surroundings(scene.surroundings),
        layer_distance_m(scene.layer_distance_m),
        material(scene.material) {}

  bool operator==(const ChangeSettings&) const = default;

  RunSettings simulation;
  sim::Surroundings surroundings;
  std::optional<double> layer_distance_m;
  sim::Material material;
};
/// Holds the vertex where it is, or lets it go.
struct TogglePin {
  sim::Index vertex = 0;
};
/// Lets go the pins of one side: those in the outer third of the pins' extent across.
struct ReleasePins {
  bool right = false;
};
struct TakeHold {
  Grip grip;
};
struct LetGo {};
/// Back to where the garment began, with the scene's pins and the present settings.
struct Reset {};
/// Back to a frame, with the pins of then and the present settings; what came after it is forgotten.
struct GoBack {
  SnapshotPtr to;
};
struct SetPaused {
  bool paused = false;
};
/// One frame while paused.
struct StepOnce {};
/// Simulated seconds in a second of the clock.
struct SetSpeed {
  double factor = 1.0;
};

using SimulationCommand = std::variant<LoadScene, ChangeSettings, TogglePin, ReleasePins, TakeHold, LetGo,
                                       Reset, GoBack, SetPaused, StepOnce, SetSpeed>;

}  // namespace taut::app
