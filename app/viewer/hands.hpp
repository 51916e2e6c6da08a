#pragma once

#include "app/viewer/simulation/simulation_command.hpp"
#include "app/viewer/state/orbit_camera.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::app {

/// The pointer in one frame of the window.
struct Pointer {
  glm::vec2 place_px{-1.0F};   ///< position, from the upper left corner of the garment's area
  glm::vec2 way_px{0.0F};      ///< movement since the frame before, or since a button went down in this frame
  std::array<bool, 3> down{};  ///< whether a button is down, indexed by renderer::PointerButton
  std::array<bool, 3> pressed{};  ///< whether it went down in this frame
  float notches = 0.0F;           ///< of the wheel, positive away from the user

  bool is_down(renderer::PointerButton button) const { return down[static_cast<std::size_t>(button)]; }
  bool was_pressed(renderer::PointerButton button) const { return pressed[static_cast<std::size_t>(button)]; }
};

/// The pointer in the scene: it turns, moves and zooms the view, and pulls the cloth.
class Hands {
 public:
  /// Handles one frame of the window. `is_free` is true if the panel does not use the pointer. Appends
  /// commands for the simulation to `commands`.
  void update(const Pointer& pointer, bool is_free, const ViewArea& area, ViewerState& state,
              std::vector<SimulationCommand>& commands);

  /// Lets go without a command. Call it when the garment has been replaced.
  void drop() { hold_.reset(); }

  /// Whether the pointer turns or moves the view, or holds cloth.
  bool is_busy() const { return is_turning_ || is_moving_ || hold_.has_value(); }
  /// The cloth that the pointer holds; empty if it holds nothing.
  std::optional<HeldCloth> held() const;

 private:
  struct Hold {
    Grip grip;
    glm::dvec3 through{0.0};    ///< point in metres of the plane that the hand moves in
    glm::dvec3 to_vertex{0.0};  ///< from the picked point to the vertex, in metres
  };

  void press(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
             std::vector<SimulationCommand>& commands);
  void pull(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
            std::vector<SimulationCommand>& commands);

  bool is_turning_ = false;
  bool is_moving_ = false;
  std::optional<Hold> hold_;
};

/// The point of the cloth that is pointed at under a pixel of its area; empty if there is none.
std::optional<PickedPoint> cloth_under(const glm::vec2& place_px, const ViewArea& area,
                                       const ViewerState& state);

}  // namespace taut::app
