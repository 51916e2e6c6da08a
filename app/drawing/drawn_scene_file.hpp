#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_file.hpp"
#include "app/scene/scene_lookup.hpp"
#include "app/scene/scene_text.hpp"

namespace taut::app {

template <class S>
struct SceneFormat;

/// All keys of a scene file, those of the picture included.
SceneFormat<DrawnScene> drawn_scene_format();

// The functions of scene_format.hpp and scene_text.hpp for that format.

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides = {});
DrawnScene read_scene_text(const std::string& text, const std::string& name,
                           std::span<const Override> overrides = {});
DrawnScene find_scene(const std::string& name, std::span<const Override> overrides);
void apply_overrides(std::span<const Override> overrides, DrawnScene& scene);
/// As that of a Scene, but drawn without balls at its pins.
void set_garment(const std::filesystem::path& file, DrawnScene& scene);
nlohmann::ordered_json scene_settings(const DrawnScene& scene);
std::string scene_text(const DrawnScene& scene, GarmentNaming naming = GarmentNaming::in_assets);

/// All keys with unit, default, range and meaning, as text for people.
std::string scene_help();

}  // namespace taut::app
