#include "app/viewer/hands.hpp"

namespace taut::app {

using renderer::PointerButton;

std::optional<PickedPoint> cloth_under(const glm::vec2& place_px, const ViewArea& area,
                                       const ViewerState& state) {
  if (!area.contains(place_px)) return std::nullopt;
  return pick(state.camera.ray_through(place_px, area), pointed_at(state).positions(),
              state.shown->loaded->garment->mesh.triangles);
}

std::optional<HeldCloth> Hands::held() const {
  return hold_ ? std::optional(HeldCloth{hold_->grip.vertices.front().vertex, hold_->grip.target_m})
               : std::nullopt;
}

void Hands::press(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
                  std::vector<SimulationCommand>& commands) {
  const auto picked = cloth_under(pointer.place_px, area, state);
  const bool is_past = state.shown != state.newest;
  if (!picked || is_past) {
    is_turning_ = true;
    return;
  }
  const std::vector<sim::Vec3>& positions = pointed_at(state).positions();
  Hold hold;
  hold.grip = take_grip(*state.shown->loaded->garment, positions, picked->vertex);
  hold.through = picked->point_m;
  hold.to_vertex = positions[picked->vertex] - picked->point_m;
  commands.emplace_back(TakeHold{hold.grip});
  hold_ = std::move(hold);
}

void Hands::pull(const Pointer& pointer, const ViewArea& area, const ViewerState& state,
                 std::vector<SimulationCommand>& commands) {
  const auto point =
      drag_point(state.camera.ray_through(pointer.place_px, area), hold_->through, state.camera.camera());
  if (point && *point + hold_->to_vertex != hold_->grip.target_m) {
    hold_->grip.target_m = *point + hold_->to_vertex;
    commands.emplace_back(TakeHold{hold_->grip});
  }
}

void Hands::update(const Pointer& pointer, bool is_free, const ViewArea& area, ViewerState& state,
                   std::vector<SimulationCommand>& commands) {
  if (is_free && area.contains(pointer.place_px)) {
    if (pointer.was_pressed(PointerButton::left)) press(pointer, area, state, commands);
    is_moving_ =
        is_moving_ || pointer.was_pressed(PointerButton::right) || pointer.was_pressed(PointerButton::middle);
    if (pointer.notches != 0.0F) state.camera.zoom(pointer.notches, pointer.place_px, area);
  }
  if (!pointer.is_down(PointerButton::left)) {
    if (hold_) commands.emplace_back(LetGo{});
    hold_.reset();
    is_turning_ = false;
  }
  is_moving_ =
      is_moving_ && (pointer.is_down(PointerButton::right) || pointer.is_down(PointerButton::middle));
  if (is_turning_) state.camera.orbit(pointer.way_px, area);
  if (is_moving_) state.camera.pan(pointer.way_px, area);
  if (hold_) pull(pointer, area, state, commands);
}

}  // namespace taut::app
