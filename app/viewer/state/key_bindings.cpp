#include "app/viewer/state/key_bindings.hpp"

#include "renderer/context/window_event.hpp"

namespace taut::app {
namespace {

namespace keys = renderer::keys;

constexpr std::array<KeyBinding, 31> bindings = {{
    {"Left drag", "on cloth: pull it; elsewhere: orbit"},
    {"Right drag", "move the view"},
    {"Wheel", "nearer to what is under the pointer, farther"},
    {"Up, Down", "more wind, less wind", keys::up, Action::more_wind, true},
    {"", "", keys::down, Action::less_wind, true},
    {"Left, Right", "turn the wind", keys::left, Action::turn_wind_left, true},
    {"", "", keys::right, Action::turn_wind_right, true},
    {"Space", "pause, go on", keys::space, Action::pause},
    {".", "one frame", keys::period, Action::step, true},
    {"Time bar", "back in time; Space goes on from there"},
    {"R", "start again, with the scene's pins", 'R', Action::reset},
    {"P", "pin or free the cloth under the pointer", 'P', Action::toggle_pin},
    {"J, K", "let go the left, the right corner", 'J', Action::release_left},
    {"", "", 'K', Action::release_right},
    {"F", "look at the whole garment", 'F', Action::show_whole_garment},
    {"1, 3, 7, 9", "from the front, the side, behind, three quarters", '1', Action::see_front},
    {"", "", '3', Action::see_side},
    {"", "", '7', Action::see_back},
    {"", "", '9', Action::see_three_quarters},
    {"F12", "picture of the scene, without the panel", keys::f12, Action::screenshot},
    {"F10", "record the scene, stop recording", keys::f10, Action::record},
    {"S", "save the settings as a scene file", 'S', Action::save_scene},
    {"E", "export the cloth as it is, as OBJ", 'E', Action::export_shape},
    {"X", "export a clip: every frame from now on; end it", 'X', Action::record_clip},
    {"C", "copy the camera as TOML", 'C', Action::copy_camera},
    {"Tab", "panel on, off", keys::tab, Action::show_panel},
    {"H", "this sheet", 'H', Action::show_keys},
    {"Esc", "close a list, or this sheet", keys::escape, Action::close_keys},
    {"Ctrl + Q", "end", 'Q', Action::quit, false, true},
    {"Ctrl + click", "on a number: type it"},
    {"Drop a file", "a model, or a scene file: load it"},
}};

}  // namespace

std::span<const KeyBinding> key_bindings() {
  return bindings;
}

}  // namespace taut::app
