#include "app/scene/scene_file.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> asset_folders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("TAUT_ASSETS"); chosen != nullptr && *chosen != '\0') {
    folders.emplace_back(chosen);
  }
  for (const fs::path& above : folders_above(own_file())) folders.push_back(above / "share" / "taut");
  folders.emplace_back(TAUT_SOURCE_ASSETS);
  return folders;
}

std::vector<BuiltInScene> scenes_in(const fs::path& folder, bool are_of_contact) {
  std::vector<BuiltInScene> scenes;
  for (const fs::path& file : list_files(folder, ".toml")) {
    scenes.push_back({file.stem().string(), file, are_of_contact});
  }
  return scenes;
}

struct Assets {
  fs::path folder;
  std::vector<BuiltInScene> scenes;
};

// Returns the built-in files. Folder and list are empty if there are none.
Assets find_assets() {
  for (const fs::path& folder : asset_folders()) {
    std::vector<BuiltInScene> scenes = scenes_in(folder / "scenes", false);
    const std::vector<BuiltInScene> of_contact = scenes_in(folder / "scenes" / "contact", true);
    scenes.insert(scenes.end(), of_contact.begin(), of_contact.end());
    if (!scenes.empty()) return {fs::absolute(folder).lexically_normal(), scenes};
  }
  return {};
}

[[noreturn]] void fail_unknown(const std::string& name) {
  const bool looks_like_file = name.find('/') != std::string::npos || fs::path(name).has_extension();
  if (looks_like_file) throw InputError("there is no file '" + name + "'");
  const auto names = collect<std::string>(built_in_scenes(), &BuiltInScene::name);
  throw InputError("there is no scene '" + name + '\'' + did_you_mean(name, names) +
                   " (built-in scenes: " + join(names) + "; a scene file or a garment file does as well)");
}

bool is_set(const Json& value) { return value.is_object() ? std::ranges::any_of(value, is_set) : !value.is_null(); }

// Writes keys before subsections, because keys after a TOML section header would belong to that section.
void append_section(std::string& text, const std::string& section, const Json& table) {
  for (const auto& [key, value] : table.items()) {
    if (!value.is_null() && !value.is_object()) text += key + " = " + toml_text(value) + '\n';
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
    if (table.contains(key) && !table[key].is_null()) table[key] = name_in_scene(models.*member, naming);
  }
}

}  // namespace

std::vector<BuiltInScene> built_in_scenes() { return find_assets().scenes; }

std::filesystem::path assets_folder() { return find_assets().folder; }

std::optional<std::filesystem::path> find_asset(const std::filesystem::path& file) {
  const fs::path assets = assets_folder();
  if (assets.empty() || file.empty() || file.is_absolute()) return std::nullopt;
  std::error_code error;
  for (const char* folder : {"", "garments", "garments/contact", "garments/outfits", "bodies", "motions", "textures"}) {
    for (const char* model_ending : {"", ".obj", ".glb", ".bvh", ".png"}) {
      const fs::path candidate = assets / folder / (file.string() + model_ending);
      if (fs::is_regular_file(candidate, error)) return candidate;
    }
  }
  return std::nullopt;
}

std::vector<fs::path> input_files(const Scene& scene) {
  std::vector<fs::path> files = scene.files_read;
  const GarmentSource& garment = scene.garment;
  files.insert(files.end(), {garment.file, garment.sewn, garment.start, garment.importer, scene.checkpoint});
  const bool is_model = !garment.file.empty() && !is_sewing_pattern(garment.file);
  if (is_model) files.push_back(landmarks_path(garment.file));
  if (std::filesystem::path(scene.fabric).has_extension()) files.emplace_back(scene.fabric);
  for (const auto& [body, source] : scene.bodies) {
    files.insert(files.end(), {source.file, source.motion, source.importer});
  }
  std::erase(files, fs::path());
  return files;
}

bool is_sewing_pattern(const std::filesystem::path& file) { return file.extension() == ".json"; }

std::filesystem::path landmarks_path(const std::filesystem::path& garment) {
  std::filesystem::path path = garment;
  return path.replace_extension(".landmarks.toml");
}

void set_garment(const std::filesystem::path& file, Scene& scene) {
  scene.title = file.filename().string();
  scene.garment.file = file;
  scene.frames = 240;
}

FoundScene locate_scene(const std::string& name) {
  const auto scenes = built_in_scenes();
  const auto built_in = std::ranges::find(scenes, name, &BuiltInScene::name);
  if (built_in != scenes.end()) return {name, built_in->file, false};
  fs::path path = name;
  std::error_code error;
  if (!fs::exists(path, error)) {
    const std::optional<fs::path> asset = find_asset(name);
    if (!asset) fail_unknown(name);
    path = *asset;
  }
  return {path.stem().string(), path, path.extension() != ".toml"};
}

bool sets(std::span<const Override> overrides, std::string_view key) {
  return std::ranges::any_of(overrides, [&](const Override& changed) { return changed.key == key; });
}

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + text + ": expected KEY=VALUE, such as --set solver.substeps=40");
  }
  return {text.substr(0, equals), text.substr(equals + 1), "--set " + text};
}

std::string name_in_scene(const std::filesystem::path& file, GarmentNaming naming) {
  const std::filesystem::path full = std::filesystem::absolute(file).lexically_normal();
  if (naming == GarmentNaming::full_path) return full.string();
  const std::filesystem::path assets = assets_folder();
  const std::filesystem::path relative = full.lexically_relative(assets);
  const bool is_inside = !assets.empty() && !relative.empty() && *relative.begin() != "..";
  return (is_inside ? relative : full).string();
}

std::string to_scene_text(Json settings, const Scene& scene, GarmentNaming naming) {
  if (!scene.checkpoint.empty() && naming == GarmentNaming::in_assets) {
    settings["start"]["checkpoint"] = std::filesystem::absolute(scene.checkpoint).string();
  }
  if (std::filesystem::path(scene.fabric).has_extension()) {
    settings["cloth"]["fabric"] = name_in_scene(scene.fabric, GarmentNaming::full_path);
  }
  Json& garment = settings["garment"];
  if (!scene.garment.file.empty()) garment.erase("grid");
  name_files(garment_files, scene.garment, naming, garment);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    name_files(body_files, scene.bodies[k].source, naming, settings["bodies"][k]);
  }
  return settings_text(settings);
}

std::string settings_text(const Json& settings) {
  std::string text;
  append_section(text, "", settings);
  return text;
}

}  // namespace taut::app
