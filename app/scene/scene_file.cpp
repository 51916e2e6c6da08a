#include "app/scene/scene_file.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

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
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") {
      scenes.push_back({entry.path().stem().string(), entry.path(), are_of_contact});
    }
  }
  std::ranges::sort(scenes, {}, &BuiltInScene::name);
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
  std::vector<std::string> names;
  for (const BuiltInScene& scene : built_in_scenes()) names.push_back(scene.name);
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

constexpr const char* ending = ".toml";

constexpr std::array settable = {
    "garment.areal_density", "cloth.bending_rigidity", "cloth.compression_stiffness", "cloth.friction",
    "cloth.shear",           "cloth.tensile_warp",     "cloth.tensile_weft",          "cloth.thickness",
    "cloth.warp_limit",      "cloth.weft_limit",       "picture.inside_colour",       "picture.outside_colour",
    "picture.roughness",     "picture.sheen",          "picture.sheen_roughness",     "picture.stitch_colour",
    "picture.threads",       "picture.translucency",   "picture.unevenness",          "picture.weave",
    "picture.weave_contrast"};

fs::path fabrics_folder() { return assets_folder() / "fabrics"; }

bool is_file_name(const std::string& name) { return fs::path(name).extension() == ending; }

/// Returns the keys that describe the fabric itself.
std::vector<Key<Fabric>> own_keys() {
  const auto read_band = [](const toml::node& value, const Source&, Fabric& fabric) {
    const toml::array* list = value.as_array();
    if (list == nullptr || list->size() != 2) return false;
    const auto lowest = finite_number((*list)[0]);
    const auto highest = finite_number((*list)[1]);
    if (!lowest || !highest || *lowest < 0.0 || *highest > 100.0 || *lowest > *highest) return false;
    fabric.published_drape_percent = {*lowest, *highest};
    return true;
  };
  return {text_key<Fabric>("title", MEMBER(title)),
          {"drape", "%", "a list of two numbers from 0 to 100, the first no larger", read_band, {}}};
}

[[noreturn]] void fail_unknown(const std::string& name, const Source& source, int line) {
  const std::vector<std::string> names = built_in_fabrics();
  const std::string message = "there is no " + (is_file_name(name) ? "file '" + name : "fabric '" + name) + '\'' +
                              did_you_mean(name, names) + " (fabrics: " + join(names) +
                              "; a file that ends in .toml does as well)";
  if (source.name.empty()) throw InputError(message);
  fail(source, line, "cloth.fabric: " + message);
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
  if (!garment.file.empty()) files.push_back(landmarks_path(garment.file));
  if (is_file_name(scene.fabric)) files.emplace_back(scene.fabric);
  for (const BodySource& body : scene.body_sources) files.insert(files.end(), {body.file, body.motion, body.importer});
  std::erase(files, fs::path());
  return files;
}

bool is_sewing_pattern(const std::filesystem::path& file) { return file.extension() == ".json"; }

std::filesystem::path landmarks_path(const std::filesystem::path& garment) {
  std::filesystem::path path = garment;
  return path.replace_extension(".landmarks.toml");
}

toml::table read_landmarks_file(const std::filesystem::path& garment) {
  const fs::path path = landmarks_path(garment);
  std::error_code error;
  if (is_sewing_pattern(garment) || !fs::exists(path, error)) return {};
  return read_toml_text(read_text_file(path), path.string());
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

std::string Fabric::published_drape_text() const {
  const auto& band = published_drape_percent;
  return band ? fmt::format("{:.0f}-{:.0f}", (*band)[0], (*band)[1]) : "";
}

std::vector<std::string> built_in_fabrics() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fabrics_folder(), error)) {
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

bool is_fabric_key(const std::string& key) { return std::ranges::find(settable, key) != settable.end(); }

bool is_passed_over(const std::string& key) { return key == "camera" || key == "picture"; }

Fabric find_fabric(const std::string& name, const Source& source, int line) {
  Fabric fabric;
  fabric.file = is_file_name(name) ? fs::path(name) : fabrics_folder() / (name + ending);
  std::error_code error;
  if (!fs::exists(fabric.file, error)) fail_unknown(name, source, line);
  fabric.name = fabric.file.stem().string();
  const Source fabric_source{fabric.file.string(), false};
  fabric.keys = read_toml_text(read_text_file(fabric.file), fabric_source.name);
  const std::vector<Key<Fabric>> keys = own_keys();
  KeyReader reader(keys, fabric_source, fabric);
  for (const Key<Fabric>& key : keys) {
    if (const toml::node* value = fabric.keys.get(key.name)) {
      reader.read_value(key.name, *value);
      fabric.keys.erase(key.name);
    }
  }
  return fabric;
}

Key<Scene> fabric_key() {
  const auto read = [](const toml::node& value, const Source& source, Scene& scene) {
    const std::optional<std::string> name = text_in(value);
    if (name) scene.fabric = is_file_name(*name) ? find_beside(source, *name).string() : *name;
    return name.has_value();
  };
  return {"cloth.fabric", "", "a text", read, [](const Scene& scene) { return Json(scene.fabric); }};
}

}  // namespace taut::app
