#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

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

/// Returns whether a file is a sewing pattern by its name: *.json.
bool is_sewing_pattern(const std::filesystem::path& file);

/// The file beside a garment that tells more of it: tshirt.landmarks.toml for tshirt.obj.
std::filesystem::path landmarks_path(const std::filesystem::path& garment);

/// The table in that file; an empty one where there is none, and of a pattern: the file tells of what was sewn of it.
/// Throws InputError where it is not TOML.
toml::table read_landmarks_file(const std::filesystem::path& garment);

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

/// Every file that a run of the scene reads, as far as it is known: bodies and garments name more when they are read.
std::vector<std::filesystem::path> input_files(const Scene& scene);

/// The name under which a scene file names a file.
std::string name_in_scene(const std::filesystem::path& file, GarmentNaming naming);

/// The scene as a scene file, from its settings (scene_format.hpp). It holds every key, so that a change of a
/// default does not change the scene. Reading it gives the same bits. ASCII only.
std::string text_of(nlohmann::ordered_json settings, const Scene& scene, GarmentNaming naming);

/// Settings, nested by section, as a scene file.
std::string settings_text(const nlohmann::ordered_json& settings);

/// A fabric's file: its weight, its stiffness and its look, as keys of scenes.
struct Fabric {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  std::string title;  ///< what it is
  /// Drape coefficients that are published of such fabrics, from and to, in percent; empty: none are known.
  std::optional<std::array<double, 2>> published_drape_percent;
  /// The same for people, "60-76", or empty.
  std::string published_drape_text() const;
  toml::table keys;  ///< of scenes, nested as in a scene file; some of is_fabric_key()
};

/// The names of the fabrics that come with the program, sorted: those of fabrics/NAME.toml in
/// assets_folder().
std::vector<std::string> built_in_fabrics();

/// Whether a fabric may set this key of a scene.
bool is_fabric_key(const std::string& key);

/// Whether a format has this in place of the keys of pictures (undrawn_format).
bool is_passed_over(const std::string& key);

/// Reads one that comes with the program by its name, or a file of the user, which ends in .toml. Throws by
/// `fail` if there is none, with what there is; InputError if the file is not as it should be.
Fabric find_fabric(const std::string& name, const Source& source = {"--fabric", true}, int line = 0);

/// The key that names the scene's fabric. It sets the name alone; see apply_fabric() in scene_format.hpp.
Key<Scene> fabric_key();

}  // namespace taut::app
