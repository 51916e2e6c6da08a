#pragma once

#include <optional>
#include <span>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// A key, or a gesture of the pointer, and what it does.
struct KeyBinding {
  const char* label;
  const char* meaning;
  int key = 0;  ///< 0: a gesture
  std::optional<Action> action = std::nullopt;
  bool repeats = false;        ///< repeats while the key stays down
  bool needs_control = false;  ///< With Ctrl. Other keys have no function together with Ctrl.
};

/// All bindings, in the order in which the window lists them.
std::span<const KeyBinding> key_bindings();

}  // namespace taut::app
