#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

// Keys of pictures whose values are neither one number nor one name.

Key<DrawnScene> camera_box_key();
Key<DrawnScene> camera_eye_key();
Key<DrawnScene> camera_target_key();
Key<DrawnScene> ground_key();
Key<DrawnScene> background_key();
Key<DrawnScene> spring_patch_key();
Key<DrawnScene> stretch_range_key();
Key<DrawnScene> texture_key();

}  // namespace taut::app
