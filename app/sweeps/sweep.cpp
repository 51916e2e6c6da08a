#include "app/sweeps/sweep.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/bytes.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

bool names_file(const std::string& key) {
  constexpr std::array names = {"file", "start", "motion", "frames", "checkpoint", "texture"};
  const std::string name = key.substr(key.rfind('.') + 1);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A fabric is a file where its name says so.
bool is_fabric_file(const std::string& key, const std::string& value) {
  return key.ends_with("fabric") && value.ends_with(".toml");
}

bool is_input(const std::string& name) {
  return name.starts_with(inputs_folder);
}

std::vector<Override> overrides(const Sweep& sweep, std::size_t run) {
  const auto in_folder = [&](const std::string& name) {
    return is_input(name) ? (fs::absolute(sweep.folder) / name).string() : name;
  };
  std::vector<Override> changes;
  const std::vector<std::size_t> choice = sweep.choice(run);
  for (std::size_t k = 0; k < choice.size(); ++k) {
    const SweepAxis& axis = sweep.axes[k];
    const Json value = with_files(axis.key, axis.values[choice[k]], in_folder);
    changes.push_back({axis.key, toml_text(value), axis.where[choice[k]]});
  }
  return changes;
}

SweepAxis read_axis(const Json& json, const std::string& where) {
  SweepAxis axis{json.at("key"), json.at("values"), {}};
  axis.where.assign(axis.values.size(), where);
  return axis;
}

}  // namespace

std::size_t Sweep::runs() const {
  std::size_t count = 1;
  for (const SweepAxis& axis : axes) {
    count *= axis.values.size();
  }
  return count;
}

std::vector<std::size_t> Sweep::choice(std::size_t run) const {
  std::vector<std::size_t> choice(axes.size());
  for (std::size_t k = axes.size(); k-- > 0; run /= axes[k].values.size()) {
    choice[k] = run % axes[k].values.size();
  }
  return choice;
}

Json Sweep::values(std::size_t run) const {
  Json values = Json::object();
  const std::vector<std::size_t> chosen = choice(run);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    values[axes[k].key] = axes[k].values[chosen[k]];
  }
  return values;
}

std::string Sweep::describe(std::size_t run) const {
  std::string text;
  const Json chosen = values(run);
  for (const auto& [key, value] : chosen.items()) {
    text += (text.empty() ? "" : ", ") + key + " = " + value_label(value);
  }
  return text;
}

std::string Sweep::scene_hash(std::size_t run) const {
  return hash_text(sim::fnv1a(sim::fnv1a(sim::fnv1a_of_nothing, scene_text), values(run).dump()));
}

DrawnScene Sweep::scene(std::size_t run) const {
  DrawnScene scene = read_scene_text(scene_text, (folder / "scene.toml").string());
  set_values(*this, run, scene);
  scene.name = fmt::format("{} run {}", scene_name, run);
  return scene;
}

fs::path Sweep::file(std::size_t run, const char* ending) const {
  return folder / "runs" / fmt::format("{:03}", run / shard_runs) / fmt::format("{:06}{}", run, ending);
}

Sweep read_sweep(const fs::path& folder) {
  const fs::path file = folder / "sweep.json";
  if (std::error_code error; !fs::exists(file, error)) {
    throw InputError("'" + folder.string() +
                     "' is no sweep: there is no sweep.json; taut sweep plan makes one");
  }
  Sweep sweep;
  sweep.folder = folder;
  try {
    const Json json = Json::parse(read_text_file(file));
    sweep.scene_name = json.at("scene");
    sweep.pictures = json.at("pictures");
    sweep.program = json.at("program");
    for (const Json& axis : json.at("axes")) {
      sweep.axes.push_back(read_axis(axis, file.string()));
    }
    sweep.scene_text = read_text_file(folder / "scene.toml");
    if (hash_text(sim::fnv1a(sim::fnv1a_of_nothing, sweep.scene_text)) != json.at("scene_hash")) {
      throw InputError("scene.toml is not what was planned");
    }
  } catch (const std::exception& error) {
    throw InputError("cannot read the sweep in '" + folder.string() + "': " + error.what());
  }
  return sweep;
}

std::string sweep_text(const Sweep& sweep, bool with_program) {
  Json axes = Json::array();
  for (const SweepAxis& axis : sweep.axes) {
    axes.push_back({{"key", axis.key}, {"values", axis.values}});
  }
  Json json = {{"scene", sweep.scene_name},
               {"scene_hash", hash_text(sim::fnv1a(sim::fnv1a_of_nothing, sweep.scene_text))},
               {"pictures", sweep.pictures},
               {"axes", axes},
               {"runs", sweep.runs()}};
  if (with_program) {
    json["program"] = sweep.program;
  }
  return json.dump(2) + '\n';
}

std::string value_label(const Json& value) {
  if (!value.is_string()) {
    return toml_text(value);
  }
  const std::string text = value;
  return is_input(text) ? fs::path(text).stem().string() : text;
}

Json with_files(const std::string& key, const Json& value,
                const std::function<std::string(const std::string&)>& rename) {
  if (value.is_string()) {
    const std::string text = value;
    return names_file(key) || is_fabric_file(key, text) ? Json(rename(text)) : value;
  }
  Json renamed = value;
  if (value.is_object()) {
    for (const auto& [name, item] : value.items()) {
      renamed[name] = with_files(name, item, rename);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      renamed[i] = with_files(key, value[i], rename);
    }
  }
  return renamed;
}

void set_values(const Sweep& sweep, std::size_t run, DrawnScene& scene) {
  try {
    static const SceneFormat<DrawnScene> format = drawn_scene_format();
    apply_overrides(format, overrides(sweep, run), scene);
  } catch (const UsageError& error) {
    throw InputError(error.what());  // of a file, not of the command line
  }
}

std::string program_hash() {
  return hash_text(sim::fnv1a(sim::fnv1a_of_nothing, read_text_file("/proc/self/exe")));
}

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace taut::app
