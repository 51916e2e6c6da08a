#include "app/drawing/drawn_scene.hpp"

#include "app/scene/scene_format.hpp"
#include "renderer/surface/refined_mesh.hpp"
#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {

std::array<double, 2> shown_stretch_range(const DrawnScene& scene) {
  constexpr double max_unbounded_stretch = 0.05;
  const std::array from_zero = {
      0.0, std::max(stretch_bound(scene).value_or(max_unbounded_stretch), sim::min_promised_bound)};
  return scene.picture.stretch_range.value_or(from_zero);
}

std::optional<double> shown_bound(const DrawnScene& scene) {
  const bool holds_shown =
      scene.picture.stretch_of == StretchOf::springs || bound_kind(scene) == sim::BoundKind::surface;
  return holds_shown ? stretch_bound(scene) : std::nullopt;
}

const char* to_name(StretchOf shown) { return shown == StretchOf::springs ? "springs" : "surface"; }

const char* legend_title(StretchOf shown) {
  return shown == StretchOf::springs ? "stretch of springs" : "stretch of the surface";
}

const char* to_name(WhichSprings which) {
  constexpr std::array names = {"none", "structural", "shear", "flexural", "all"};
  return names[static_cast<std::size_t>(which)];
}

renderer::PictureSettings to_picture_settings(const PictureStyle& style) {
  renderer::PictureSettings settings = style.settings;
  if (style.quality == DrawingQuality::draft) {
    settings.samples = 1;
    settings.sky_directions = 6;
    settings.shadow_taps = 8;
  }
  if (style.quality == DrawingQuality::high) {
    settings.supersampling = std::min(2 * settings.supersampling, 8);
    settings.shadow_map_px = 4096;
    settings.sky_directions = 32;
  }
  if (style.quality == DrawingQuality::final) {
    settings.passes = style.passes;
    settings.sky_directions = 0;  // every pass has its own
  }
  return settings;
}

float min_edge_px(const PictureStyle& style) {
  constexpr std::array lengths_px = {16.0F, renderer::min_split_px, 6.0F, 8.0F};
  return lengths_px[static_cast<std::size_t>(style.quality)];
}

renderer::Backdrop to_backdrop(const Background& background) {
  renderer::Backdrop backdrop;
  if (background.kind == BackgroundKind::colour) backdrop.lower_colour = backdrop.upper_colour = background.colour;
  backdrop.transparent = background.kind == BackgroundKind::transparent;
  return backdrop;
}

DrawnScene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides) {
  return read_scene_text(read_text_file(path), path.string(), overrides);
}

DrawnScene read_scene_text(const std::string& text, const std::string& name, std::span<const Override> overrides) {
  return read_scene(drawn_scene_format(), text, name, overrides);
}

DrawnScene find_scene(const std::string& name, std::span<const Override> overrides) {
  DrawnScene scene = find_scene(drawn_scene_format(), name, overrides);
  // The scene's floor may not fit another body.
  if (sets(overrides, "body.file") && !sets(overrides, "picture.ground")) scene.picture.ground = {};
  return scene;
}

std::vector<std::filesystem::path> input_files(const DrawnScene& scene) {
  std::vector<std::filesystem::path> files = input_files(static_cast<const Scene&>(scene));
  if (names_image(scene.picture.texture)) files.push_back(scene.picture.texture);
  return files;
}

void require_inputs_kept(const std::vector<std::filesystem::path>& outputs, const DrawnScene& scene,
                         const std::vector<std::filesystem::path>& read) {
  std::vector<std::filesystem::path> inputs = input_files(scene);
  inputs.insert(inputs.end(), read.begin(), read.end());
  require_distinct_files(outputs, inputs);
}

void apply_overrides(std::span<const Override> overrides, DrawnScene& scene) {
  apply_overrides(drawn_scene_format(), overrides, scene);
}

void set_garment(const std::filesystem::path& file, DrawnScene& scene) {
  set_garment(file, static_cast<Scene&>(scene));
  scene.picture.show_pins = false;
}

Json scene_settings(const DrawnScene& scene) { return scene_to_json(drawn_scene_format(), scene); }

std::string scene_text(const DrawnScene& scene, GarmentNaming naming) {
  Json settings = scene_settings(scene);
  if (names_image(scene.picture.texture)) settings["picture"]["texture"] = name_in_scene(scene.picture.texture, naming);
  return to_scene_text(std::move(settings), scene, naming);
}

std::string scene_help() {
  std::string text =
      "A scene file is TOML. Every key has a default, apart from the garment: one of\n"
      "garment.file and [garment.grid]. The same keys work with --set KEY=VALUE.\n\n";
  const DrawnScene defaults;
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) text += describe_key(key, defaults);
  return text + list_entries_help();
}

}  // namespace taut::app
