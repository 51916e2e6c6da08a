#pragma once

#include <string>

#include "app/scene/scene.hpp"
#include "app/scene/scene_value.hpp"

namespace taut::app {

/// How a garment that comes with the program is named: relative to `assets_folder` (scene_lookup.hpp), which
/// is the same on every machine, or by its full path, which any reader of scene files finds. Others have
/// their full path.
enum class GarmentNaming { in_assets, full_path };

/// The scene as a scene file, from its settings (scene_format.hpp): every key, whether it was given or not,
/// so that a later default changes nothing. Reads back bit for bit. ASCII only.
std::string text_of(ValueTable settings, const Scene& scene, GarmentNaming naming);

}  // namespace taut::app
