#include "app/scene/scene_lists.hpp"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "app/scene/scene_keys.hpp"

namespace taut::app {
namespace {

std::optional<NearestTo> nearest_of(const Value& value) {
  const ValueTable* table = value.table();
  if (table == nullptr || table->size() != 1 || table->front().key != "nearest") {
    return std::nullopt;
  }
  const auto point = three_numbers(table->front().value);
  return point ? std::optional(NearestTo{{(*point)[0], (*point)[1], (*point)[2]}}) : std::nullopt;
}

std::optional<PinSelector> pin_of(const Value& value) {
  if (value.text() != nullptr) {
    return *value.text();
  }
  if (const auto index = whole_number(value); index && *index >= 0 && *index < 0xFFFFFFFFLL) {
    return static_cast<sim::Index>(*index);
  }
  if (const auto nearest = nearest_of(value)) {
    return *nearest;
  }
  return std::nullopt;
}

bool read_pins(const Value& value, const Source&, Scene& scene) {
  std::vector<PinSelector> pins;
  if (value.text() != nullptr) {
    if (*value.text() != "none") {
      pins.emplace_back(*value.text());
    }
    scene.pins = pins;
    return true;
  }
  if (value.list() == nullptr) {
    return false;
  }
  for (const Value& item : *value.list()) {
    const auto pin = pin_of(item);
    if (!pin) {
      return false;
    }
    pins.push_back(*pin);
  }
  scene.pins = pins;
  return true;
}

bool read_layer_distance(const Value& value, const Source&, Scene& scene) {
  const bool from_mesh = value.text() != nullptr && *value.text() == "auto";
  const std::optional<double> distance_m = finite_number(value);
  if (!from_mesh && !(distance_m && *distance_m >= 0.0)) {
    return false;
  }
  scene.layer_distance_m = distance_m;
  return true;
}

Value write_layer_distance(const Scene& scene) {
  return scene.layer_distance_m ? Value{*scene.layer_distance_m} : Value{std::string("auto")};
}

struct PinWriter {
  Value operator()(const std::string& name) const { return {name}; }
  Value operator()(sim::Index vertex) const { return {static_cast<std::int64_t>(vertex)}; }
  Value operator()(const NearestTo& nearest) const {
    const sim::Vec3& p = nearest.point_m;
    return {ValueTable{{"nearest", list_of({p.x, p.y, p.z})}}};
  }
};

Value write_pins(const Scene& scene) {
  if (!scene.pins) {
    return {};
  }
  ValueList list;
  for (const PinSelector& pin : *scene.pins) {
    list.push_back(std::visit(PinWriter{}, pin));
  }
  return {list};
}

template <class T>
Value write_entry(const std::vector<Key<T>>& keys, const T& entry) {
  ValueTable table;
  for (const Key<T>& key : keys) {
    const Value value = key.write(entry);
    if (is_set(value)) {
      table.push_back({key.name, value});
    }
  }
  return {table};
}

const char* shape_name(const sim::Shape& shape) {
  constexpr std::array names = {"plane", "sphere", "capsule"};
  return names[shape.index()];
}

std::optional<sim::Collider> collider_of_shape(const std::string& name) {
  for (const sim::Shape& shape :
       {sim::Shape(sim::Plane{}), sim::Shape(sim::Sphere{}), sim::Shape(sim::Capsule{})}) {
    if (name == shape_name(shape)) {
      return sim::Collider{.shape = shape};
    }
  }
  return std::nullopt;
}

sim::Collider read_collider(const Value& value, const Source& source) {
  const std::string expected = "expected a shape, \"plane\" or \"sphere\" or \"capsule\"";
  for (const auto& [key, item] : *value.table()) {
    if (key != "shape") {
      continue;
    }
    auto collider = item.text() != nullptr ? collider_of_shape(*item.text()) : std::nullopt;
    if (!collider) {
      fail(source, item.line, "colliders.shape: found " + to_text(item) + ", " + expected);
    }
    const auto keys = collider_keys(*item.text());
    KeyReader(keys, source, *collider).read(*value.table());
    if (auto* plane = std::get_if<sim::Plane>(&collider->shape)) {
      plane->normal = glm::normalize(plane->normal);
    }
    return *collider;
  }
  fail(source, value.line, "an entry of colliders has no shape; " + expected);
}

bool is_list_of_tables(const Value& value) {
  const auto is_table = [](const Value& item) { return item.table() != nullptr; };
  return value.list() != nullptr && std::all_of(value.list()->begin(), value.list()->end(), is_table);
}

bool read_colliders(const Value& value, const Source& source, Scene& scene) {
  if (!is_list_of_tables(value)) {
    return false;
  }
  scene.surroundings.colliders.clear();
  for (const Value& item : *value.list()) {
    scene.surroundings.colliders.push_back(read_collider(item, source));
  }
  return true;
}

Value write_colliders(const Scene& scene) {
  ValueList list;
  for (const sim::Collider& collider : scene.surroundings.colliders) {
    list.push_back(write_entry(collider_keys(shape_name(collider.shape)), collider));
  }
  return {list};
}

bool read_forces(const Value& value, const Source& source, Scene& scene) {
  if (!is_list_of_tables(value)) {
    return false;
  }
  const auto keys = force_keys();
  scene.surroundings.forces.artificial_forces.clear();
  for (const Value& item : *value.list()) {
    sim::PointForce force;
    KeyReader(keys, source, force).read(*item.table());
    scene.surroundings.forces.artificial_forces.push_back(force);
  }
  return true;
}

Value write_forces(const Scene& scene) {
  ValueList list;
  for (const sim::PointForce& force : scene.surroundings.forces.artificial_forces) {
    list.push_back(write_entry(force_keys(), force));
  }
  return {list};
}

// Files are named relative to the scene that names them.
std::filesystem::path beside(const Source& source, const std::filesystem::path& file) {
  const auto folder =
      source.is_command_line ? std::filesystem::path() : std::filesystem::path(source.name).parent_path();
  return (folder / file).lexically_normal();
}

Key<Scene> file_name_key(std::string name, std::filesystem::path GarmentSource::*member,
                         std::string meaning) {
  auto read = [member](const Value& value, const Source& source, Scene& scene) {
    if (value.text() == nullptr || value.text()->empty()) {
      return false;
    }
    scene.garment.*member = beside(source, *value.text());
    return true;
  };
  auto write = [member](const Scene& scene) {
    const std::filesystem::path& file = scene.garment.*member;
    return file.empty() ? Value{} : Value{file.string()};
  };
  return {std::move(name), "", "a file name", std::move(meaning), read, write};
}

}  // namespace

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
  auto read = [](const Value& value, const Source& source, Scene& scene) {
    if (value.text() == nullptr) {
      return false;
    }
    scene.checkpoint = value.text()->empty() ? std::filesystem::path() : beside(source, *value.text());
    return true;
  };
  auto write = [](const Scene& scene) {
    return scene.checkpoint.empty() ? Value{} : Value{scene.checkpoint.string()};
  };
  return {"start.checkpoint",
          "",
          "a file name",
          "the run begins with this saved moment, relative to the scene file; without it: as modelled",
          read,
          write};
}

Key<Scene> up_key() {
  auto read = [](const Value& value, const Source&, Scene& scene) {
    if (value.text() == nullptr) {
      return false;
    }
    if (*value.text() == "auto") {
      scene.garment.up.reset();
      return true;
    }
    const auto* const name = std::find(axis_names.begin(), axis_names.end(), *value.text());
    if (name == axis_names.end()) {
      return false;
    }
    scene.garment.up = static_cast<ModelAxis>(name - axis_names.begin());
    return true;
  };
  auto write = [](const Scene& scene) {
    return Value{
        std::string(scene.garment.up ? axis_names[static_cast<std::size_t>(*scene.garment.up)] : "auto")};
  };
  return {"garment.up",
          "",
          "\"auto\" or \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\"",
          "the model's direction that is up; auto: what the file says, or else a guess from its size",
          read,
          write};
}

Key<Scene> pins_key() {
  return {
      "pins.at",
      "",
      "\"none\" or a list of landmark names, grid names (\"top-left\", ...), vertex numbers and "
      "{ nearest = [x, y, z] }",
      "vertices that are held; not set: the upper edge of a grid, each part of a model by its top. Numbers "
      "count from 0: a grid's vertices row by row from the top left; the v lines of an OBJ file; the "
      "vertices of other files, mesh after mesh; where a format shares no vertices between faces (STL, "
      "FBX, Collada) the corners of its faces. taut inspect says which, and how many",
      read_pins,
      write_pins};
}

Key<Scene> forces_key() {
  return {"forces", "", "a list of tables [[forces]]", "pulls on single vertices", read_forces, write_forces};
}

Key<Scene> colliders_key() {
  return {"colliders",    "", "a list of tables [[colliders]]", "what cloth cannot enter", read_colliders,
          write_colliders};
}

Key<Scene> layer_distance_key() {
  return {
      "cloth.layer_distance",
      "m",
      "\"auto\" or a number from 0",
      "kept between layers of the cloth, about its mesh's edge length; auto: what suits the mesh, as when a "
      "model is given without a scene; 0: they pass through",
      read_layer_distance,
      write_layer_distance};
}

std::vector<std::pair<std::string, sim::SolverKind>> solver_choices() {
  std::vector<std::pair<std::string, sim::SolverKind>> choices;
  for (const sim::SolverKind kind : sim::all_solver_kinds) {
    choices.emplace_back(sim::name_of(kind), kind);
  }
  return choices;
}

std::vector<std::pair<std::string, sim::VectorUnit>> vector_unit_choices() {
  std::vector<std::pair<std::string, sim::VectorUnit>> choices;
  for (const sim::VectorUnit unit : sim::all_vector_units) {
    choices.emplace_back(sim::name_of(unit), unit);
  }
  return choices;
}

}  // namespace taut::app
