#pragma once

#include <filesystem>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

/// The scene as a scene file: every key, whether it was given or not, so that a later default changes
/// nothing. Reads back bit for bit. A garment that comes with the program is named relative to
/// `assets_folder`, another by its full path. ASCII only.
std::string scene_text(const Scene& scene);

/// Where the built-in scenes and their garments are; empty where there are none.
std::filesystem::path assets_folder();

}  // namespace taut::app
