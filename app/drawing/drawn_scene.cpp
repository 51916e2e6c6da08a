#include "app/drawing/drawn_scene.hpp"

#include "app/scene/scene_format.hpp"
#include "renderer/surface/refined_mesh.hpp"
#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {

std::array<double, 2> shown_stretch_range(const DrawnScene& scene) {
  constexpr double most_without_bound = 0.05;
  const std::array from_zero = {
      0.0, std::max(stretch_bound(scene).value_or(most_without_bound), sim::smallest_promised_bound)};
  return scene.picture.stretch_range.value_or(from_zero);
}

std::optional<double> shown_bound(const DrawnScene& scene) {
  const bool holds_shown =
      scene.picture.stretch_of == StretchOf::springs || bound_kind(scene) == sim::BoundKind::surface;
  return holds_shown ? stretch_bound(scene) : std::nullopt;
}

const char* name_of(StretchOf shown) { return shown == StretchOf::springs ? "springs" : "surface"; }

const char* legend_title(StretchOf shown) {
  return shown == StretchOf::springs ? "stretch of springs" : "stretch of the surface";
}

const char* name_of(WhichSprings which) {
  constexpr std::array names = {"none", "structural", "shear", "flexural", "all"};
  return names[static_cast<std::size_t>(which)];
}

renderer::PictureSettings settings_of(const PictureStyle& style) {
  renderer::PictureSettings settings = style.settings;
  if (style.quality == DrawingQuality::draft) {
    settings.samples = 1;
    settings.sky_directions = 12;
    settings.shadow_taps = 8;
  }
  if (style.quality == DrawingQuality::high) {
    settings.supersampling = std::min(2 * settings.supersampling, 8);
    settings.shadow_map_px = 4096;
    settings.sky_directions = 64;
  }
  return settings;
}

float shortest_edge_px(const PictureStyle& style) {
  constexpr std::array lengths_px = {16.0F, renderer::shortest_split_px, 4.0F};
  return lengths_px[static_cast<std::size_t>(style.quality)];
}

renderer::Backdrop backdrop_of(const Background& background) {
  renderer::Backdrop backdrop;
  if (background.kind == BackgroundKind::colour) {
    backdrop.lower_colour = backdrop.upper_colour = background.colour;
  }
  backdrop.transparent = background.kind == BackgroundKind::transparent;
  return backdrop;
}

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides) {
  return read_scene_text(read_text_file(path), path.string(), overrides);
}

DrawnScene read_scene_text(const std::string& text, const std::string& name,
                           std::span<const Override> overrides) {
  return read_scene(drawn_scene_format(), text, name, overrides);
}

DrawnScene find_scene(const std::string& name, std::span<const Override> overrides) {
  DrawnScene scene = find_scene(drawn_scene_format(), name, overrides);
  // The scene's floor may not be where another body stands.
  if (sets(overrides, "body.file") && !sets(overrides, "picture.ground")) scene.picture.ground = {};
  return scene;
}

void apply_overrides(std::span<const Override> overrides, DrawnScene& scene) {
  apply_overrides(drawn_scene_format(), overrides, scene);
}

void set_garment(const std::filesystem::path& file, DrawnScene& scene) {
  set_garment(file, static_cast<Scene&>(scene));
  scene.picture.show_pins = false;
}

Json scene_settings(const DrawnScene& scene) { return settings_of(drawn_scene_format(), scene); }

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
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) text += describe_key(key, defaults);
  return text + list_entries_help();
}

}  // namespace taut::app
