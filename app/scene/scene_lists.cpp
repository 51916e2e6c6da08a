#include "app/scene/scene_lists.hpp"

#include <filesystem>

#include "app/scene/scene_keys.hpp"

namespace taut::app {
namespace {

std::optional<NearestTo> nearest_of(const toml::node& value) {
  const toml::table* table = value.as_table();
  const toml::node* nearest = table != nullptr && table->size() == 1 ? table->get("nearest") : nullptr;
  const auto point = nearest != nullptr ? three_numbers(*nearest) : std::nullopt;
  return point ? std::optional(NearestTo{{(*point)[0], (*point)[1], (*point)[2]}}) : std::nullopt;
}

std::optional<PinSelector> pin_of(const toml::node& value) {
  if (const auto text = text_in(value)) {
    return *text;
  }
  if (const auto index = whole_number(value); index && *index >= 0 && *index < 0xFFFFFFFFLL) {
    return static_cast<sim::Index>(*index);
  }
  if (const auto nearest = nearest_of(value)) {
    return *nearest;
  }
  return std::nullopt;
}

bool read_pins(const toml::node& value, const Source&, Scene& scene) {
  const auto pins = text_in(value) == "none" ? std::vector<PinSelector>{} : pins_in(value);
  if (pins) {
    scene.pins = *pins;
  }
  return pins.has_value();
}

struct PinWriter {
  Json operator()(const std::string& name) const { return name; }
  Json operator()(sim::Index vertex) const { return vertex; }
  Json operator()(const NearestTo& nearest) const {
    const sim::Vec3& p = nearest.point_m;
    return Json::object({{"nearest", {p.x, p.y, p.z}}});
  }
};

Json write_pins(const Scene& scene) {
  return scene.pins ? json_of(*scene.pins) : Json();
}

bool read_forces(const toml::node& value, const Source& source, Scene& scene) {
  if (!is_list_of_tables(value)) {
    return false;
  }
  const auto keys = force_keys();
  scene.surroundings.forces.artificial_forces.clear();
  for (const toml::node& item : *value.as_array()) {
    sim::PointForce force;
    KeyReader(keys, source, force).read(*item.as_table());
    scene.surroundings.forces.artificial_forces.push_back(force);
  }
  return true;
}

Json write_forces(const Scene& scene) {
  Json list = Json::array();
  for (const sim::PointForce& force : scene.surroundings.forces.artificial_forces) {
    list.push_back(write_entry(force_keys(), force));
  }
  return list;
}

Key<Scene> file_name_key(std::string name, std::filesystem::path GarmentSource::*member,
                         std::string meaning) {
  auto read = [member](const toml::node& value, const Source& source, Scene& scene) {
    const auto text = text_in(value);
    if (!text || text->empty()) {
      return false;
    }
    scene.garment.*member = beside(source, *text);
    return true;
  };
  auto write = [member](const Scene& scene) {
    const std::filesystem::path& file = scene.garment.*member;
    return file.empty() ? Json() : Json(file.string());
  };
  return {std::move(name), "", "a file name", std::move(meaning), read, write};
}

}  // namespace

std::optional<std::vector<PinSelector>> pins_in(const toml::node& value) {
  if (const auto text = text_in(value)) {
    return std::vector<PinSelector>{*text};
  }
  if (!value.is_array()) {
    return std::nullopt;
  }
  std::vector<PinSelector> pins;
  for (const toml::node& item : *value.as_array()) {
    const auto pin = pin_of(item);
    if (!pin) {
      return std::nullopt;
    }
    pins.push_back(*pin);
  }
  return pins;
}

Json json_of(const std::vector<PinSelector>& pins) {
  Json list = Json::array();
  for (const PinSelector& pin : pins) {
    list.push_back(std::visit(PinWriter{}, pin));
  }
  return list;
}

Key<Scene> file_key() {
  return file_name_key("garment.file", &GarmentSource::file,
                       "a 3D model, relative to the scene file; without it: a grid");
}

Key<Scene> start_key() {
  return file_name_key("garment.start", &GarmentSource::start,
                       "where the cloth begins, which keeps the rest shape above: a model of its vertices in "
                       "their order, in metres with y up, as taut simulate --export writes it");
}

Key<Scene> checkpoint_key() {
  auto read = [](const toml::node& value, const Source& source, Scene& scene) {
    const auto text = text_in(value);
    if (text) {
      scene.checkpoint = text->empty() ? std::filesystem::path() : beside(source, *text);
    }
    return text.has_value();
  };
  auto write = [](const Scene& scene) {
    return scene.checkpoint.empty() ? Json() : Json(scene.checkpoint.string());
  };
  return {"start.checkpoint",
          "",
          "a file name",
          "the run begins with this saved moment, relative to the scene file; without it: as modelled",
          read,
          write};
}

std::vector<std::pair<std::string, std::optional<ModelAxis>>> up_choices() {
  std::vector<std::pair<std::string, std::optional<ModelAxis>>> choices = {{"auto", std::nullopt}};
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    choices.emplace_back(axis_names[i], static_cast<ModelAxis>(i));
  }
  return choices;
}

Key<Scene> pins_key() {
  return {"pins.at",
          "",
          "\"none\" or \"hanger\" or a list of landmark names, grid names (\"top-left\", ...), vertex "
          "numbers and "
          "{ nearest = [x, y, z] }",
          "vertices that are held; not set: the upper edge of a grid, each part of a model by its top. "
          "\"hanger\": "
          "none, but two bars below its shoulders. Numbers "
          "count from 0: a grid's vertices row by row from the top left; the v lines of an OBJ file; the "
          "vertices of other files, mesh after mesh; where a format shares no vertices between faces (STL, "
          "FBX, Collada) the corners of its faces. taut inspect says which, and how many",
          read_pins,
          write_pins};
}

Key<Scene> weld_key() {
  constexpr Range range = {0.0, 0.05};
  auto read = [range](const toml::node& value, const Source&, Scene& scene) {
    const std::optional<double> number = finite_number(value, "m");
    const bool is_number = number && range.contains(*number);
    if (is_number || text_in(value) == "auto") {
      scene.garment.weld_m = number;
      return true;
    }
    return false;
  };
  auto write = [](const Scene& scene) { return scene.garment.weld_m ? Json(*scene.garment.weld_m) : Json(); };
  return {"garment.weld",
          "m",
          "\"auto\" or " + describe("a number", range),
          "borders of the model nearer to each other than this are sewn together; auto: borders of different "
          "parts within 1 mm, where it is beyond doubt what belongs together; 0: none",
          read,
          write};
}

Key<Scene> forces_key() {
  return {"forces", "", "a list of tables [[forces]]", "pulls on single vertices", read_forces, write_forces};
}

}  // namespace taut::app
