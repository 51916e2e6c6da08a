#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace taut::app {

/// A scene that comes with the program.
struct BuiltInScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_of_contact = false;  ///< one of those about contact, which take minutes
};

/// The scenes that come with the program: the files scenes/NAME.toml in assets_folder(), sorted by name, and
/// then those about contact, scenes/contact/NAME.toml.
std::vector<BuiltInScene> built_in_scenes();

/// The first of these folders that holds scenes: $TAUT_ASSETS; that of the installed program; that of the
/// source tree. Empty if there is none.
std::filesystem::path assets_folder();

/// A file that comes with the program: "garments/tshirt_1028.obj", or by its name alone, with its ending or
/// without. Empty if there is none.
std::optional<std::filesystem::path> find_asset(const std::filesystem::path& file);

/// The meaning of the argument SCENE.
struct FoundScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_garment = false;  ///< a garment file instead of a scene file
};

/// Finds a scene file, a garment file or a built-in scene by name. Throws InputError.
FoundScene locate_scene(const std::string& name);

/// Sets the scene to a default scene for this garment file.
void set_garment(const std::filesystem::path& file, Scene& scene);

}  // namespace taut::app
