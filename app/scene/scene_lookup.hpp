#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {

struct BuiltInScene {
  std::string name;
  std::filesystem::path file;
};

/// The files scenes/NAME.toml of the first folder of assets that has any: $TAUT_ASSETS, the one the program
/// is installed with, the one of its source tree. By name.
std::vector<BuiltInScene> built_in_scenes();

/// A scene by what was given for SCENE: a scene file, a garment file (hung by its top and looked at whole) or
/// the name of a built-in scene. Throws InputError, UsageError for an override.
Scene find_scene(const std::string& name, std::span<const Override> overrides);

}  // namespace taut::app
