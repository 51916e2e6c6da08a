#pragma once

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

// Keys of scenes whose values are neither one number nor one name.

Key<Scene> file_key();
Key<Scene> start_key();
Key<Scene> checkpoint_key();
Key<Scene> up_key();
Key<Scene> pins_key();
Key<Scene> forces_key();
Key<Scene> bodies_key();
Key<Scene> layer_distance_key();

}  // namespace taut::app
