#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/commands/options.hpp"
#include "app/scene/fabric.hpp"

namespace taut::app {
namespace {

void print_table(const std::vector<std::string>& names) {
  fmt::print("{:<8} {:>6} {:>6} {:>8} {:>6}\n{:<8} {:>6} {:>6} {:>8} {:>6}\n", "", "weight", "thick", "bending",
             "drape", "", "g/m2", "mm", "uN m", "%");
  for (const std::string& name : names) {
    const sim::Material material = set_fabric({}, name).material;
    const Fabric fabric = find_fabric(name);
    fmt::print("{:<8} {:>6.0f} {:>6.2f} {:>8.3g} {:>6}  {}\n", name, 1e3 * material.areal_density_kg_per_m2,
               1e3 * material.thickness_m, 1e6 * material.bending_rigidity_n_m, fabric.published_drape_text(),
               fabric.title);
  }
}

}  // namespace

int list_scenes(const std::string& scene) {
  if (!scene.empty()) {
    fmt::print("{}", scene_text(find_scene(scene, {}), GarmentNaming::in_assets));
    return 0;
  }
  const std::vector<BuiltInScene> scenes = built_in_scenes();
  if (scenes.empty()) {
    throw InputError("no built-in scenes were found; set TAUT_ASSETS to the folder that holds scenes/");
  }
  std::size_t width = 0;
  for (const BuiltInScene& each : scenes) width = std::max(width, each.name.size());
  bool is_of_contact = scenes.front().is_of_contact;
  for (const BuiltInScene& each : scenes) {
    fmt::print("{}{:<{}}  {}\n", each.is_of_contact == is_of_contact ? "" : "\n", each.name, width,
               read_scene_file(each.file).title);
    is_of_contact = each.is_of_contact;
  }
  return 0;
}

int list_fabrics(const std::string& fabric) {
  const std::vector<std::string> names = built_in_fabrics();
  if (names.empty()) throw InputError("no fabrics were found; set TAUT_ASSETS to the folder that holds fabrics/");
  if (!fabric.empty()) {
    fmt::print("{}", read_text_file(find_fabric(fabric).file));
    return 0;
  }
  print_table(names);
  return 0;
}

}  // namespace taut::app
