#pragma once

#include <optional>
#include <span>

#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// A key or a gesture and what it does; the key sheet lists them all.
struct KeyBinding {
  const char* label;
  const char* meaning;
  int key = 0;  ///< 0: a gesture
  std::optional<Action> action = std::nullopt;
  bool repeats = false;        ///< goes on while the key is held
  bool needs_control = false;  ///< with Ctrl; any other key is none of ours with it
};

std::span<const KeyBinding> key_bindings();

}  // namespace taut::app
