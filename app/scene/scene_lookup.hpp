#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/files.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {

struct BuiltInScene {
  std::string name;
  std::filesystem::path file;
};

/// The files scenes/NAME.toml of the first folder of assets that has any: $TAUT_ASSETS, the one the program
/// is installed with, the one of its source tree. By name.
std::vector<BuiltInScene> built_in_scenes();

/// Where the built-in scenes and their garments are; empty where there are none.
std::filesystem::path assets_folder();

/// What was given for SCENE.
struct FoundScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_garment = false;  ///< a garment file, and not a scene file
};

/// A scene file, a garment file or the name of a built-in scene. Throws InputError.
FoundScene locate_scene(const std::string& name);

/// What is simulated of a garment file that comes without a scene.
void set_garment(const std::filesystem::path& file, Scene& scene);

/// A scene by what was given for SCENE. Throws InputError, UsageError for an override.
template <class S>
S find_scene(const SceneFormat<S>& format, const std::string& name, std::span<const Override> overrides) {
  const FoundScene found = locate_scene(name);
  S scene;
  if (found.is_garment) {
    set_garment(found.file, scene);
    apply_overrides(format, overrides, scene);
  } else {
    scene = read_scene(format, read_text_file(found.file), found.file.string(), overrides);
  }
  scene.name = found.name;
  return scene;
}

}  // namespace taut::app
