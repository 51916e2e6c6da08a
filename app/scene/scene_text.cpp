#include "app/scene/scene_text.hpp"

#include <algorithm>

#include "app/scene/scene_file.hpp"
#include "app/scene/scene_lookup.hpp"
#include "app/scene/scene_value.hpp"

namespace taut::app {
namespace {

bool is_set(const Json& value) {
  return value.is_object() ? std::any_of(value.begin(), value.end(), is_set) : !value.is_null();
}

// Keys first, then the sections below: behind a section's header TOML has no way back.
void append_section(std::string& text, const std::string& section, const Json& table) {
  for (const auto& [key, value] : table.items()) {
    if (!value.is_null() && !value.is_object()) {
      text += key + " = " + toml_text(value) + '\n';
    }
  }
  for (const auto& [key, value] : table.items()) {
    if (value.is_object() && is_set(value)) {
      const std::string name = section.empty() ? key : section + '.' + key;
      text += "\n[" + name + "]\n";
      append_section(text, name, value);
    }
  }
}

template <class Files, class Models>
void name_files(const Files& files, const Models& models, GarmentNaming naming, Json& table) {
  for (const auto& [key, member] : files) {
    if (table.contains(key) && !table[key].is_null()) {
      table[key] = name_in_scene(models.*member, naming);
    }
  }
}

}  // namespace

std::string name_in_scene(const std::filesystem::path& file, GarmentNaming naming) {
  const std::filesystem::path full = std::filesystem::absolute(file).lexically_normal();
  if (naming == GarmentNaming::full_path) {
    return full.string();
  }
  const std::filesystem::path assets = assets_folder();
  const std::filesystem::path relative = full.lexically_relative(assets);
  const bool is_inside = !assets.empty() && !relative.empty() && *relative.begin() != "..";
  return (is_inside ? relative : full).string();
}

std::string text_of(Json settings, const Scene& scene, GarmentNaming naming) {
  if (!scene.checkpoint.empty() && naming == GarmentNaming::in_assets) {
    settings["start"]["checkpoint"] = std::filesystem::absolute(scene.checkpoint).string();
  }
  if (std::filesystem::path(scene.fabric).has_extension()) {
    settings["cloth"]["fabric"] = name_in_scene(scene.fabric, GarmentNaming::full_path);
  }
  Json& garment = settings["garment"];
  if (!scene.garment.file.empty()) {
    garment.erase("grid");
  }
  name_files(garment_files, scene.garment, naming, garment);
  for (std::size_t k = 0; k < scene.body_sources.size(); ++k) {
    name_files(body_files, scene.body_sources[k], naming, settings["bodies"][k]);
  }
  return settings_text(settings);
}

std::string settings_text(const Json& settings) {
  std::string text;
  append_section(text, "", settings);
  return text;
}

}  // namespace taut::app
