#pragma once

#include <string>

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

// Keys of what moves by itself: bodies, and pins in groups.

Key<Scene> bodies_key();
Key<Scene> moving_pins_key();

/// The keys of [[pins.moving]] and [[bodies]], as describe_key() writes them.
std::string moving_entries_help();

}  // namespace taut::app
