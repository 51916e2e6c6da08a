#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/files.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {

/// A scene that comes with the program.
struct BuiltInScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
};

/// The scenes that come with the program, sorted by name: the files scenes/NAME.toml in assets_folder().
std::vector<BuiltInScene> built_in_scenes();

/// The first of these folders that holds scenes: $TAUT_ASSETS; that of the installed program; that of the
/// source tree. Empty if there is none.
std::filesystem::path assets_folder();

/// What the argument SCENE means.
struct FoundScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_garment = false;  ///< a garment file instead of a scene file
};

/// Finds a scene file, a garment file or a built-in scene by name. Throws InputError.
FoundScene locate_scene(const std::string& name);

/// Sets the scene to a default scene for this garment file.
void set_garment(const std::filesystem::path& file, Scene& scene);

/// Returns the scene that the argument SCENE means. Throws InputError; UsageError for an override.
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
