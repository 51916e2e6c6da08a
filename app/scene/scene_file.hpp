#pragma once

#include <nlohmann/json_fwd.hpp>

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

/// A key that was set on the command line.
struct Override {
  std::string key;
  std::string value;
  std::string option;  ///< the whole option, for messages: "--set solver.substeps=40"
};

/// Returns whether one of them sets this key.
bool sets(std::span<const Override> overrides, std::string_view key);

/// Reads "KEY=VALUE". Throws UsageError if there is no "=".
Override parse_override(const std::string& text);

/// The keys of [garment] that name files, and their members.
inline constexpr std::array garment_files = {std::pair("file", &GarmentSource::file),
                                             std::pair("start", &GarmentSource::start)};
/// The same of the keys of [[bodies]].
inline constexpr std::array body_files = {std::pair("file", &BodySource::file),
                                          std::pair("motion", &BodySource::motion)};

/// How a scene file names a garment or a body that comes with the program. `in_assets`: relative to
/// assets_folder(), the same on every machine. `full_path`: readable by any program. Others always have their
/// full path.
enum class GarmentNaming { in_assets, full_path };

/// The name under which a scene file names a file.
std::string name_in_scene(const std::filesystem::path& file, GarmentNaming naming);

/// The scene as a scene file, from its settings (scene_format.hpp). It holds every key, so that a change of a
/// default does not change the scene. Reading it gives the same bits. ASCII only.
std::string text_of(nlohmann::ordered_json settings, const Scene& scene, GarmentNaming naming);

/// Settings, nested by section, as a scene file.
std::string settings_text(const nlohmann::ordered_json& settings);

}  // namespace taut::app
