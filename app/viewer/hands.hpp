#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/viewer/simulation/simulation_command.hpp"
#include "app/viewer/state/picking.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::app {

/// The pointer as it is in a frame of the window.
struct Pointer {
  glm::vec2 place_px{-1.0F};
  glm::vec2 way_px{0.0F};         ///< since the frame before, or since a button went down in this one
  std::array<bool, 3> down{};     ///< by renderer::PointerButton
  std::array<bool, 3> pressed{};  ///< went down in this frame
  float notches = 0.0F;           ///< of the wheel

  bool is_down(renderer::PointerButton button) const { return down[static_cast<std::size_t>(button)]; }
  bool was_pressed(renderer::PointerButton button) const { return pressed[static_cast<std::size_t>(button)]; }
};

/// What the pointer does to the scene: turns, moves and scales the view, and pulls the cloth.
class Hands {
 public:
  /// `is_free`: the pointer is not the panel's. Adds what the simulation shall do.
  void update(const Pointer& pointer, bool is_free, const ViewArea& area, ViewerState& state,
              std::vector<SimulationCommand>& commands);

  /// Forgets what is held, for a garment that is gone.
  void drop() { hold_.reset(); }

  bool is_busy() const { return is_turning_ || is_moving_ || hold_.has_value(); }
  /// The vertex that is held.
  std::optional<sim::Index> held_vertex() const;

 private:
  struct Hold {
    Grip grip;
    glm::dvec3 through{0.0};    ///< a point of the plane that the hand moves in
    glm::dvec3 to_vertex{0.0};  ///< from where the pointer took hold
  };

  void press(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
             std::vector<SimulationCommand>& commands);
  void pull(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
            std::vector<SimulationCommand>& commands);

  bool is_turning_ = false;
  bool is_moving_ = false;
  std::optional<Hold> hold_;
};

/// The cloth under the pointer, of what is shown.
std::optional<PickedPoint> cloth_under(const glm::vec2& place_px, const ViewArea& area,
                                       const ViewerState& state);

}  // namespace taut::app
