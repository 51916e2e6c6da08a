#pragma once

#include "app/base/files.hpp"
#include "app/scene/fabric.hpp"

namespace taut::app {

/// Returns all keys that the simulation needs. Scene files, `--set` and `taut help scene` use this table.
std::vector<Key<Scene>> scene_keys();

/// Format of scenes of type S, which is Scene or derived from it.
template <class S> struct SceneFormat {
  std::vector<Key<S>> keys;
  /// Checks that involve several keys. Throws by `fail` (scene_key.hpp).
  std::function<void(const S&, const Source&)> check;
};

/// Returns the format with the keys that the simulation needs.
SceneFormat<Scene> simulation_format();

/// Returns the format for reading only: it ignores the picture sections of files.
SceneFormat<Scene> undrawn_format();

/// Returns the material of a fabric. Throws UsageError with this option in the message if there is no such name or
/// file.
sim::Material find_fabric_material(const std::string& fabric, const std::string& option);

/// Sets a key of one body. "body.file" adds a mesh body, named after its file. Other keys "body.KEY" set KEY of
/// [[bodies]] for the last mesh body. Returns false if the name does not begin with "body.". Throws by `fail`.
bool set_body_key(const std::string& name, const toml::node& value, const Source& source, Scene& scene);

/// Returns the table of the file beside a garment (landmarks_path()). Empty if there is no file, and for a pattern,
/// because the file describes the garment that was sewn from it. Throws InputError if the file is not TOML.
toml::table read_landmarks_file(const std::filesystem::path& garment);

/// Requires that the file names exactly one garment: a model or a grid. Throws by `fail` (scene_key.hpp).
void require_one_garment(const toml::table& file, const Source& source);

/// Requires that the garment's files exist. `named`: files of the scene file; `used`: files after overrides. Overridden
/// files are not checked. Throws by `fail`.
void require_garment(const toml::table& file, const Source& source, const GarmentSource& named,
                     const GarmentSource& used);

/// Requires that the file of key garment.KEY exists. `line`: its line in the scene file; 0: none. Throws by `fail`.
void require_named(const std::string& key, const std::filesystem::path& named, const Source& source, int line);

/// Applies the fabric that the text `value` names. Throws as find_fabric() does, and InputError if its file has a key
/// or a value that is not valid.
template <class S>
void apply_fabric(const SceneFormat<S>& format, const toml::node& value, const Source& source, S& scene) {
  KeyReader(format.keys, source, scene).read_value("cloth.fabric", value);
  if (scene.fabric.empty()) return;
  const Fabric fabric = find_fabric(scene.fabric, source, line_number(value));
  std::vector<Key<S>> keys = format.keys;
  std::erase_if(keys, [](const Key<S>& key) { return !is_fabric_key(key.name) && !is_passed_over(key.name); });
  KeyReader(keys, {fabric.file.string(), false}, scene).read(fabric.keys);
}

/// Sets the keys of command-line options, starting with a fabric's keys, and checks the scene. Throws UsageError.
template <class S> void apply_overrides(const SceneFormat<S>& format, std::span<const Override> overrides, S& scene) {
  for (const auto& [key, text, option] : overrides) {
    if (key == "cloth.fabric") apply_fabric(format, *read_toml_value(text).get("value"), {option, true}, scene);
  }
  for (const auto& [key, text, option] : overrides) {
    const toml::table parsed = read_toml_value(text);
    const toml::node& value = *parsed.get("value");
    const Source source{option, true};
    if (!set_body_key(key, value, source, scene)) KeyReader(format.keys, source, scene).read_value(key, value);
    for (const auto& [name, member] : garment_files) {
      if (key == std::string("garment.") + name) require_named(name, scene.garment.*member, source, line_number(value));
    }
  }
  if (!overrides.empty()) format.check(scene, {overrides.back().option, true});
}

/// Applies the settings of the file beside the garment: its fabric, fabric = "denim", unless an override names one, and
/// its bound, max_stretch = 0.6.
template <class S> void apply_own_fabric(const SceneFormat<S>& format, std::span<const Override> overrides, S& scene) {
  const auto sets_fabric = [](const Override& changed) { return changed.key == "cloth.fabric"; };
  const toml::table beside = read_landmarks_file(scene.garment.file);
  const Source source{landmarks_path(scene.garment.file).string(), false};
  const toml::node* fabric = beside.get("fabric");
  if (fabric != nullptr && std::ranges::none_of(overrides, sets_fabric)) apply_fabric(format, *fabric, source, scene);
  const toml::node* bound = beside.get("max_stretch");
  if (bound != nullptr) KeyReader(format.keys, source, scene).read_value("solver.max_stretch", *bound);
}

/// Reads a scene from text. `name` is its file; relative garment files are relative to it. Throws InputError that names
/// the file, the line, the key, the value found and the value expected. Throws UsageError for an override.
template <class S>
S read_scene(const SceneFormat<S>& format, const std::string& text, const std::string& name,
             std::span<const Override> overrides) {
  const toml::table file = read_toml_text(text, name);
  const Source source{name, false};
  S scene;
  if (const toml::node* fabric = file["cloth"]["fabric"].node()) apply_fabric(format, *fabric, source, scene);
  KeyReader(format.keys, source, scene).read(file);
  require_one_garment(file, source);
  format.check(scene, source);
  const GarmentSource named = scene.garment;
  apply_overrides(format, overrides, scene);
  require_garment(file, source, named, scene.garment);
  return scene;
}

/// Returns the scene that the argument SCENE names. Throws InputError; UsageError for an override.
template <class S>
S find_scene(const SceneFormat<S>& format, const std::string& name, std::span<const Override> overrides) {
  const FoundScene location = locate_scene(name);
  S scene;
  if (location.is_garment) {
    set_garment(location.file, scene);
    apply_own_fabric(format, overrides, scene);
    apply_overrides(format, overrides, scene);
  } else {
    scene = read_scene(format, read_text_file(location.file), location.file.string(), overrides);
  }
  scene.name = location.name;
  scene.files_read.push_back(location.file);
  return scene;
}

/// Returns all keys with their values, nested as in a file.
template <class S> Json scene_to_json(const SceneFormat<S>& format, const S& scene) {
  Json settings;
  for (const Key<S>& key : format.keys) settings[pointer_to(key.name)] = key.write(scene);
  return settings;
}

/// Returns a help text for a key: default, unit, range and meaning. `list` precedes the key of a list's entry.
template <class T> std::string describe_key(const Key<T>& key, const T& defaults, const std::string& list = "") {
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  const std::string own_meaning = key_meaning(list + key.name),
                    meaning = own_meaning.empty() ? key_meaning(key.name) : own_meaning;
  return "  " + key.name + " = " + to_text(key.write(defaults)) + unit + "\n      " + key.expected +
         (meaning.empty() ? "" : "; " + meaning) + '\n';
}

/// Returns the help text for the keys of [[forces]], [[pins.moving]] and [[bodies]].
std::string list_entries_help();

// Keys of scenes whose values are neither a number nor a name.

Key<Scene> pins_key();
Key<Scene> weld_key();
Key<Scene> gravity_path_key();
Key<Scene> forces_key();
Key<Scene> bodies_key();
Key<Scene> moving_pins_key();

/// Makes a key for the direction that is up in a model.
template <class T, class Access> Key<T> up_key(std::string name, Access access) {
  std::vector<std::pair<std::string, std::optional<ModelAxis>>> choices = {{"auto", std::nullopt}};
  for (std::size_t i = 0; i < axis_names.size(); ++i) choices.emplace_back(axis_names[i], static_cast<ModelAxis>(i));
  Key<T> key = choice_key<T>(std::move(name), choices, access);
  key.expected = "\"auto\" or \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\"";
  return key;
}

}  // namespace taut::app
