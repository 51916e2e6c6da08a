#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

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
