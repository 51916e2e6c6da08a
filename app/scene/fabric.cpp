#include "app/scene/fabric.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

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
    const auto band = numbers_in<2>(value);
    if (!band || band->front() < 0.0 || band->back() > 100.0 || band->front() > band->back()) return false;
    fabric.published_drape_percent = band;
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

std::string Fabric::published_drape_text() const {
  const auto& band = published_drape_percent;
  return band ? fmt::format("{:.0f}-{:.0f}", (*band)[0], (*band)[1]) : "";
}

std::vector<std::string> built_in_fabrics() {
  return collect<std::string>(list_files(fabrics_folder(), ending),
                              [](const fs::path& file) { return file.stem().string(); });
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
