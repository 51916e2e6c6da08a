#pragma once

#include <filesystem>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

/// How a garment that comes with the program is named: relative to `assets_folder`, which is the same on
/// every machine, or by its full path, which any reader of scene files finds. Others have their full path.
enum class GarmentNaming { in_assets, full_path };

/// The scene as a scene file: every key, whether it was given or not, so that a later default changes
/// nothing. Reads back bit for bit. ASCII only.
std::string scene_text(const Scene& scene, GarmentNaming naming = GarmentNaming::in_assets);

/// Where the built-in scenes and their garments are; empty where there are none.
std::filesystem::path assets_folder();

}  // namespace taut::app
