#include "app/scene/scene_lookup.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "app/base/errors.hpp"
#include "app/base/own_file.hpp"
#include "app/base/suggest.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> asset_folders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("TAUT_ASSETS"); chosen != nullptr && *chosen != '\0') {
    folders.emplace_back(chosen);
  }
  for (const fs::path& above : folders_above(own_file())) {
    folders.push_back(above / "share" / "taut");
  }
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
  std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return scenes;
}

struct Assets {
  fs::path folder;
  std::vector<BuiltInScene> scenes;
};

// Both are empty where there is none.
Assets find_assets() {
  for (const fs::path& folder : asset_folders()) {
    std::vector<BuiltInScene> scenes = scenes_in(folder / "scenes", false);
    const std::vector<BuiltInScene> of_contact = scenes_in(folder / "scenes" / "contact", true);
    scenes.insert(scenes.end(), of_contact.begin(), of_contact.end());
    if (!scenes.empty()) {
      return {fs::absolute(folder).lexically_normal(), scenes};
    }
  }
  return {};
}

[[noreturn]] void fail_unknown(const std::string& name) {
  const bool looks_like_file = name.find('/') != std::string::npos || fs::path(name).has_extension();
  if (looks_like_file) {
    throw InputError("there is no file '" + name + "'");
  }
  std::vector<std::string> names;
  for (const BuiltInScene& scene : built_in_scenes()) {
    names.push_back(scene.name);
  }
  throw InputError("there is no scene '" + name + '\'' + did_you_mean(name, names) +
                   " (built-in scenes: " + joined(names) + "; a scene file or a garment file does as well)");
}

}  // namespace

std::vector<BuiltInScene> built_in_scenes() {
  return find_assets().scenes;
}

std::filesystem::path assets_folder() {
  return find_assets().folder;
}

std::optional<std::filesystem::path> find_asset(const std::filesystem::path& file) {
  const fs::path assets = assets_folder();
  if (assets.empty() || file.empty() || file.is_absolute()) {
    return std::nullopt;
  }
  std::error_code error;
  for (const char* folder : {"", "garments", "garments/contact", "bodies", "motions", "textures"}) {
    for (const char* ending : {"", ".obj", ".glb", ".bvh", ".png"}) {
      const fs::path candidate = assets / folder / (file.string() + ending);
      if (fs::is_regular_file(candidate, error)) {
        return candidate;
      }
    }
  }
  return std::nullopt;
}

void set_garment(const std::filesystem::path& file, Scene& scene) {
  scene.title = file.filename().string();
  scene.garment.file = file;
  scene.frames = 240;
}

FoundScene locate_scene(const std::string& name) {
  const auto scenes = built_in_scenes();
  const auto built_in = std::find_if(scenes.begin(), scenes.end(),
                                     [&](const BuiltInScene& scene) { return scene.name == name; });
  if (built_in != scenes.end()) {
    return {name, built_in->file, false};
  }
  fs::path path = name;
  std::error_code error;
  if (!fs::exists(path, error)) {
    const std::optional<fs::path> asset = find_asset(name);
    if (!asset) {
      fail_unknown(name);
    }
    path = *asset;
  }
  return {path.stem().string(), path, path.extension() != ".toml"};
}

}  // namespace taut::app
