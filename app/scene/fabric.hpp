#pragma once

#include "app/scene/scene_file.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// A fabric file: weight, stiffness and look of a fabric as keys of scenes.
struct Fabric {
  std::string name;  ///< without folder and extension
  std::filesystem::path file;
  std::string title;  ///< description
  /// Range of published drape coefficients of such fabrics, in percent; empty: none are known.
  std::optional<std::array<double, 2>> published_drape_percent;
  /// Returns the range as a text, "60-76", or an empty text.
  std::string published_drape_text() const;
  toml::table keys;  ///< keys of scenes, nested as in a scene file; only those of is_fabric_key()
};

/// Returns the names of the built-in fabrics, sorted: files fabrics/NAME.toml in assets_folder().
std::vector<std::string> built_in_fabrics();

/// Returns true if a fabric may set this key of a scene.
bool is_fabric_key(const std::string& key);

/// Returns true if this is a key of pictures, which undrawn_format() ignores.
bool is_passed_over(const std::string& key);

/// Reads a built-in fabric by its name, or the user's file, which ends in .toml. Throws by `fail`, with the names of
/// all fabrics, if there is none; without a source it throws InputError. Throws InputError if the file is not valid.
Fabric find_fabric(const std::string& name, const Source& source = {}, int line = 0);

/// Returns the key that names the scene's fabric. It sets only the name; see apply_fabric() in scene_format.hpp.
Key<Scene> fabric_key();

}  // namespace taut::app
