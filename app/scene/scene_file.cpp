#include "app/scene/scene_file.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/scene/promise.hpp"
#include "app/scene/scene_keys.hpp"
#include "app/scene/toml_reader.hpp"

namespace taut::app {
namespace {

// What no single key can check.
void check_whole(const Scene& scene, const Source& source) {
  if (scene.camera.eye.has_value() != scene.camera.target.has_value()) {
    fail(source, 0, "camera.eye and camera.target are needed together; one is missing");
  }
  if (scene.camera.eye && *scene.camera.eye == *scene.camera.target) {
    fail(source, 0, "camera.eye and camera.target are the same point");
  }
  if (const std::optional<std::string> reason = beyond_promise(scene)) {
    fail(source, 0, *reason);
  }
}

const Value* find(const ValueTable& table, const std::string& key) {
  for (const auto& [name, value] : table) {
    if (name == key) {
      return &value;
    }
  }
  return nullptr;
}

void check_garment(const ValueTable& file, const Source& source) {
  const Value* garment = find(file, "garment");
  const ValueTable none;
  const ValueTable& keys = garment != nullptr && garment->table() != nullptr ? *garment->table() : none;
  const bool has_file = find(keys, "file") != nullptr;
  const bool has_grid = find(keys, "grid") != nullptr;
  if (has_file == has_grid) {
    fail(source, garment != nullptr ? garment->line : 0,
         std::string(has_file ? "both garment.file and [garment.grid] are" : "no garment is") +
             " given; expected one of [garment] file = \"...\" and [garment.grid]");
  }
}

// Here and not where it is read, which does not know who names it.
void require_garment(const std::filesystem::path& garment, const Source& source, int line) {
  try {
    require_file(garment);
  } catch (const InputError& error) {
    fail(source, line, std::string("garment.file: ") + error.what());
  }
}

void require_garment(const ValueTable& file, const Source& source, const std::filesystem::path& garment) {
  const Value* section = find(file, "garment");
  const Value* key = section != nullptr ? find(*section->table(), "file") : nullptr;
  if (key != nullptr) {
    require_garment(garment, source, key->line);
  }
}

void apply(std::span<const Override> overrides, const std::vector<Key<Scene>>& keys, Scene& scene) {
  for (const Override& changed : overrides) {
    const Source source{changed.option, true};
    KeyReader(keys, source, scene).read_value(changed.key, read_toml_value(changed.value));
    if (changed.key == "garment.file") {
      require_garment(scene.garment.file, source, 0);
    }
  }
  if (!overrides.empty()) {
    check_whole(scene, {overrides.back().option, true});
  }
}

void insert(ValueTable& table, const std::string& name, const Value& value) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    table.push_back({name, value});
    return;
  }
  const std::string section = name.substr(0, dot);
  if (find(table, section) == nullptr) {
    table.push_back({section, Value{ValueTable{}}});
  }
  for (auto& [key, inner] : table) {
    if (key == section) {
      insert(std::get<ValueTable>(inner.data), name.substr(dot + 1), value);
    }
  }
}

template <class T>
std::string describe_key(const std::string& prefix, const Key<T>& key, const T& defaults) {
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  std::string text = fmt::format("  {} = {}{}\n", prefix + key.name, to_text(key.write(defaults)), unit);
  text += fmt::format("      {}", key.expected);
  return text + (key.meaning.empty() ? "\n" : fmt::format("; {}\n", key.meaning));
}

}  // namespace

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set " + text + ": expected KEY=VALUE, such as --set solver.substeps=40");
  }
  return {text.substr(0, equals), text.substr(equals + 1), "--set " + text};
}

Scene read_scene_file(const std::filesystem::path& path, std::span<const Override> overrides) {
  return read_scene_text(read_text_file(path), path.string(), overrides);
}

Scene read_scene_text(const std::string& text, const std::string& name, std::span<const Override> overrides) {
  const Value file = read_toml_text(text, name);
  const Source source{name, false};
  const std::vector<Key<Scene>> keys = scene_keys();
  Scene scene;
  KeyReader(keys, source, scene).read(*file.table());
  check_garment(*file.table(), source);
  check_whole(scene, source);
  const std::filesystem::path garment = scene.garment.file;
  apply(overrides, keys, scene);
  if (scene.garment.file == garment) {
    require_garment(*file.table(), source, garment);
  }
  return scene;
}

void apply_overrides(std::span<const Override> overrides, Scene& scene) {
  apply(overrides, scene_keys(), scene);
}

Value scene_settings(const Scene& scene) {
  ValueTable table;
  for (const Key<Scene>& key : scene_keys()) {
    insert(table, key.name, key.write(scene));
  }
  return {table};
}

std::string scene_help() {
  std::string text =
      "A scene file is TOML. Every key has a default, apart from the garment: one of\n"
      "garment.file and [garment.grid]. The same keys work with --set KEY=VALUE.\n\n";
  const Scene defaults;
  for (const Key<Scene>& key : scene_keys()) {
    text += describe_key("", key, defaults);
  }
  text += "\nEach [[forces]]:\n";
  for (const auto& key : force_keys()) {
    text += describe_key("", key, sim::PointForce{});
  }
  for (const sim::Shape& shape :
       {sim::Shape(sim::Plane{}), sim::Shape(sim::Sphere{}), sim::Shape(sim::Capsule{})}) {
    constexpr std::array names = {"plane", "sphere", "capsule"};
    text += fmt::format("\nEach [[colliders]] with shape = \"{}\":\n", names[shape.index()]);
    for (const auto& key : collider_keys(names[shape.index()])) {
      if (key.name != "shape") {
        text += describe_key("", key, sim::Collider{.shape = shape});
      }
    }
  }
  return text;
}

}  // namespace taut::app
