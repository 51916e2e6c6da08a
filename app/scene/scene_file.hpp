#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/scene/scene.hpp"

namespace taut::app {

/// A built-in scene.
struct BuiltInScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_of_contact = false;  ///< a scene of the folder `contact`; these take minutes
};

/// Returns the built-in scenes, sorted by name: first the files scenes/NAME.toml in assets_folder(), then
/// scenes/contact/NAME.toml.
std::vector<BuiltInScene> built_in_scenes();

/// Returns the first of these folders that has scenes: $TAUT_ASSETS, the installation's, the source tree's. Empty if
/// there is none.
std::filesystem::path assets_folder();

/// Returns a built-in file for its path, "garments/tshirt_1028.obj", or its name, with or without its extension. Empty
/// if there is none.
std::optional<std::filesystem::path> find_asset(const std::filesystem::path& file);

/// A scene that the argument SCENE names.
struct FoundScene {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  bool is_garment = false;  ///< a garment file instead of a scene file
};

/// Finds a scene file, a garment file or a built-in scene by name. Throws InputError.
FoundScene locate_scene(const std::string& name);

/// Returns true if this is the file name of a sewing pattern: *.json.
bool is_sewing_pattern(const std::filesystem::path& file);

/// Returns the file with more facts about a garment: tshirt.landmarks.toml for tshirt.obj.
std::filesystem::path landmarks_path(const std::filesystem::path& garment);

/// Makes a default scene for this garment file.
void set_garment(const std::filesystem::path& file, Scene& scene);

/// A key set on the command line.
struct Override {
  std::string key;
  std::string value;
  std::string option;  ///< whole option, for messages: "--set solver.substeps=40"
};

/// Returns true if one of the overrides sets this key.
bool sets(std::span<const Override> overrides, std::string_view key);

/// Reads "KEY=VALUE". Throws UsageError if there is no "=".
Override parse_override(const std::string& text);

/// Keys of [garment] that name files, with their members.
inline constexpr std::array garment_files = {std::pair("file", &GarmentSource::file),
                                             std::pair("start", &GarmentSource::start)};
/// Keys of [[bodies]] that name files, with their members.
inline constexpr std::array body_files = {std::pair("file", &BodySource::file),
                                          std::pair("motion", &BodySource::motion)};

/// Naming of built-in files in a scene file. `in_assets`: relative to assets_folder(), the same on every machine.
/// `full_path`: readable by any program. Other files always have their full path.
enum class GarmentNaming { in_assets, full_path };

/// Returns the files that a run of the scene reads, as far as known. Bodies and garments name more when they are read.
std::vector<std::filesystem::path> input_files(const Scene& scene);

/// Returns the name of a file in a scene file.
std::string name_in_scene(const std::filesystem::path& file, GarmentNaming naming);

/// Returns a scene file with these settings (scene_format.hpp). It has every key, so that a changed default does not
/// change the scene. It is ASCII and reads back with the same bits.
std::string to_scene_text(nlohmann::ordered_json settings, const Scene& scene, GarmentNaming naming);

/// Returns a scene file with these settings, which are nested by section.
std::string settings_text(const nlohmann::ordered_json& settings);

}  // namespace taut::app
