#pragma once

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

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
