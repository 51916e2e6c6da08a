#include "app/drawing/drawn_scene_file.hpp"

#include <algorithm>

#include "app/scene/scene_format.hpp"

namespace taut::app {

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides) {
  return read_scene_text(read_text_file(path), path.string(), overrides);
}

DrawnScene read_scene_text(const std::string& text, const std::string& name,
                           std::span<const Override> overrides) {
  return read_scene(drawn_scene_format(), text, name, overrides);
}

DrawnScene find_scene(const std::string& name, std::span<const Override> overrides) {
  DrawnScene scene = find_scene(drawn_scene_format(), name, overrides);
  const auto gives = [&](const char* key) {
    return std::any_of(overrides.begin(), overrides.end(), [&](const Override& o) { return o.key == key; });
  };
  // The scene's floor may not be where another body stands.
  if (gives("body.file") && !gives("picture.ground")) {
    scene.picture.ground = {};
  }
  return scene;
}

void apply_overrides(std::span<const Override> overrides, DrawnScene& scene) {
  apply_overrides(drawn_scene_format(), overrides, scene);
}

void set_garment(const std::filesystem::path& file, DrawnScene& scene) {
  set_garment(file, static_cast<Scene&>(scene));
  scene.picture.show_pins = false;
}

Json scene_settings(const DrawnScene& scene) {
  return settings_of(drawn_scene_format(), scene);
}

std::string scene_text(const DrawnScene& scene, GarmentNaming naming) {
  Json settings = scene_settings(scene);
  if (names_image(scene.picture.texture)) {
    settings["picture"]["texture"] = name_in_scene(scene.picture.texture, naming);
  }
  return text_of(std::move(settings), scene, naming);
}

std::string scene_help() {
  std::string text =
      "A scene file is TOML. Every key has a default, apart from the garment: one of\n"
      "garment.file and [garment.grid]. The same keys work with --set KEY=VALUE.\n"
      "A length, speed, weight, angle or time may carry its unit: \"1 mm\", \"36 km/h\".\n\n";
  const DrawnScene defaults;
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) {
    text += describe_key(key, defaults);
  }
  return text + list_entries_help();
}

}  // namespace taut::app
