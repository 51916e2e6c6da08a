#include "app/sweeps/sweep.hpp"

#include "app/base/errors.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

bool names_file(const std::string& key) {
  constexpr std::array names = {"file", "start", "motion", "frames", "checkpoint", "texture"};
  const std::string name = key.substr(key.rfind('.') + 1);
  return std::ranges::find(names, name) != names.end();
}

/// A fabric is a file where its name says so.
bool is_fabric_file(const std::string& key, const std::string& value) {
  return key.ends_with("fabric") && value.ends_with(".toml");
}

bool is_input(const std::string& name) { return name.starts_with(inputs_folder); }

/// The value of a key with every file's name in it replaced by what `rename` makes of it, those of lists too.
Json with_files(const std::string& key, const Json& value,
                const std::function<std::string(const std::string&)>& rename) {
  if (value.is_string()) {
    const std::string text = value;
    return names_file(key) || is_fabric_file(key, text) ? Json(rename(text)) : value;
  }
  Json renamed = value;
  if (value.is_object()) {
    for (const auto& [name, item] : value.items()) renamed[name] = with_files(name, item, rename);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) renamed[i] = with_files(key, value[i], rename);
  }
  return renamed;
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

/// Sets keys of a scene from values: files relative to `folder`, where they have inputs_folder. Throws
/// InputError.
void set_values(const Sweep& sweep, std::size_t run, DrawnScene& scene) {
  try {
    static const SceneFormat<DrawnScene> format = drawn_scene_format();
    apply_overrides(format, overrides(sweep, run), scene);
  } catch (const UsageError& error) {
    throw InputError(error.what());  // of a file, not of the command line
  }
}

struct Study {
  std::string scene;
  int frames = 0;  ///< 0: as the scene has it
  bool pictures = false;
};

const std::vector<Key<Study>>& study_keys() {
  static const std::vector<Key<Study>> keys = {
      text_key<Study>("scene", MEMBER(scene), "what every run begins as"),
      whole_key<Study>("frames", {1, 1000000}, MEMBER(frames), "length of every run"),
      switch_key<Study>("pictures", MEMBER(pictures), "every run draws its last frame")};
  return keys;
}

/// Keys may stand in quotes, "wind.speed", or without, which TOML reads as tables in tables.
void read_axes(const toml::table& table, const std::string& section, const Source& source, Sweep& sweep) {
  for (const auto& [name, node] : entries_of(table)) {
    const std::string key = section.empty() ? name : section + '.' + name;
    const toml::array* list = node->as_array();
    if (const toml::table* inner = node->as_table()) {
      read_axes(*inner, key, source, sweep);
      continue;
    }
    if (list == nullptr || list->empty()) {
      fail(source, line_of(*node), key + ": found " + to_text(*node) + ", expected a list of values");
    }
    SweepAxis& axis = sweep.axes.emplace_back(SweepAxis{key, {}, {}});
    for (const toml::node& value : *list) {
      axis.values.push_back(json_of(value));
      axis.where.push_back(fmt::format("{}:{}", source.name, line_of(value)));
    }
  }
}

/// Names of files that are there become full paths, which mean the same in any folder.
std::string full_name(const std::string& name, const Source& source) {
  const fs::path file = beside(source, name);
  return name.empty() || !fs::exists(file) ? name : fs::absolute(file).lexically_normal().string();
}

/// All that belongs to a file that a scene names: itself and what it needs beside it.
std::vector<fs::path> files_of(const fs::path& named) {
  constexpr std::array belongings = {".landmarks.toml", ".mtl", ".bin", ".png", ".jpg"};
  std::vector<fs::path> files = {named};
  for (const char* ending : belongings) {
    const fs::path other = named.parent_path() / (named.stem().string() + ending);
    if (other != named && fs::is_regular_file(other)) files.push_back(other);
  }
  return files;
}

/// Gathers the files that a sweep names.
class Inputs {
 public:
  /// The name of a file in the sweep's folder; what is no file stays as it is.
  std::string name_of(const std::string& full) {
    if (!fs::path(full).is_absolute()) return full;
    std::string& name = names_[full];
    if (name.empty()) {
      const std::vector<fs::path> files = files_of(full);
      std::uint64_t hash = sim::fnv1a_of_nothing;
      for (const fs::path& file : files) {
        hash = sim::fnv1a(sim::fnv1a(hash, file.filename().string()), read_text_file(file));
      }
      const fs::path folder = fs::path(inputs_folder) / hash_text(hash);
      for (const fs::path& file : files) copies.emplace_back(file, folder / file.filename());
      name = (folder / fs::path(full).filename()).string();
    }
    return name;
  }

  std::vector<std::pair<fs::path, fs::path>> copies;

 private:
  std::map<std::string, std::string> names_;  ///< by full path
};

void require_few(const Sweep& sweep, const std::string& study) {
  double runs = 1.0;
  for (const SweepAxis& axis : sweep.axes) runs *= static_cast<double>(axis.values.size());
  if (runs > static_cast<double>(most_runs)) {
    throw InputError("{}: the axes make {:.0f} runs, expected at most {}", study, runs, most_runs);
  }
}

void require_valid(const Sweep& sweep, const DrawnScene& base) {
  for (std::size_t run = 0; run < sweep.runs(); ++run) {
    throw_if_interrupted();
    DrawnScene scene = base;
    set_values(sweep, run, scene);
  }
}

std::string manifest_of(const Sweep& sweep) {
  std::string text;
  for (std::size_t run = 0; run < sweep.runs(); ++run) {
    text +=
        Json{
            {"index", run}, {"values", sweep.values(run)}, {"scene", sweep.scene_hash(run)}, {"program", sweep.program}}
            .dump() +
        '\n';
  }
  return text;
}

Study read_study(const fs::path& file, Sweep& sweep) {
  const Source source{file.string(), false};
  toml::table table = read_toml_text(read_text_file(file), source.name);
  const toml::table* axes = table["axes"].as_table();
  if (axes == nullptr) fail(source, 0, "expected a table [axes], such as \"wind.speed\" = [0, 1, 10]");
  read_axes(*axes, "", source, sweep);
  table.erase("axes");
  Study study;
  KeyReader(study_keys(), source, study).read(table);
  if (study.scene.empty()) {
    fail(source, 0, "expected scene = \"...\", " + std::string("a scene or a garment file"));
  }
  const fs::path beside_study = file.parent_path() / study.scene;
  study.scene = fs::is_regular_file(beside_study) ? beside_study.string() : study.scene;
  return study;
}

}  // namespace

std::size_t Sweep::runs() const {
  std::size_t count = 1;
  for (const SweepAxis& axis : axes) count *= axis.values.size();
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
  for (std::size_t k = 0; k < axes.size(); ++k) values[axes[k].key] = axes[k].values[chosen[k]];
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
    throw InputError("'" + folder.string() + "' is no sweep: there is no sweep.json; taut sweep plan makes one");
  }
  Sweep sweep;
  sweep.folder = folder;
  try {
    const Json json = Json::parse(read_text_file(file));
    sweep.scene_name = json.at("scene");
    sweep.pictures = json.at("pictures");
    sweep.program = json.at("program");
    for (const Json& axis : json.at("axes")) sweep.axes.push_back(read_axis(axis, file.string()));
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
  for (const SweepAxis& axis : sweep.axes) axes.push_back({{"key", axis.key}, {"values", axis.values}});
  Json json = {{"scene", sweep.scene_name},
               {"scene_hash", hash_text(sim::fnv1a(sim::fnv1a_of_nothing, sweep.scene_text))},
               {"pictures", sweep.pictures},
               {"axes", axes},
               {"runs", sweep.runs()}};
  if (with_program) json["program"] = sweep.program;
  return json.dump(2) + '\n';
}

std::string value_label(const Json& value) {
  if (!value.is_string()) return toml_text(value);
  const std::string text = value;
  return is_input(text) ? fs::path(text).stem().string() : text;
}

std::string program_hash() { return hash_text(sim::fnv1a(sim::fnv1a_of_nothing, read_text_file("/proc/self/exe"))); }

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

PlannedSweep plan_sweep(const fs::path& file, const fs::path& folder) {
  PlannedSweep planned;
  Sweep& sweep = planned.sweep;
  const Study study = read_study(file, sweep);
  require_few(sweep, file.string());
  DrawnScene base = find_scene(study.scene, {});
  base.frames = study.frames > 0 ? study.frames : base.frames;
  for (SweepAxis& axis : sweep.axes) {
    for (Json& value : axis.values) {
      value = with_files(axis.key, value, [&](const auto& name) { return full_name(name, {file.string()}); });
    }
  }
  require_valid(sweep, base);

  Inputs inputs;
  const auto taken_in = [&](const std::string& name) { return inputs.name_of(name); };
  for (SweepAxis& axis : sweep.axes) {
    for (Json& value : axis.values) value = with_files(axis.key, value, taken_in);
  }
  Json settings = scene_settings(base);
  if (!base.garment.file.empty()) settings["garment"].erase("grid");
  settings = with_files("", settings, [&](const auto& name) { return full_name(name, {name, true}); });
  sweep.scene_text = settings_text(with_files("", settings, taken_in));
  sweep.folder = folder;
  sweep.scene_name = base.name;
  sweep.pictures = study.pictures;
  sweep.program = program_hash();
  planned.copies = std::move(inputs.copies);
  return planned;
}

bool write_sweep(const PlannedSweep& planned) {
  const Sweep& sweep = planned.sweep;
  const fs::path& folder = sweep.folder;
  if (fs::exists(folder / "sweep.json")) {
    const Sweep there = read_sweep(folder);
    if (sweep_text(there, false) != sweep_text(sweep, false)) {
      throw InputError("'" + folder.string() +
                       "' holds the sweep of another study; choose another folder, or remove it");
    }
    if (there.program == sweep.program && fs::exists(folder / "manifest")) return false;
  }
  prepare_folder_of(folder / "sweep.json");
  for (const auto& [from, to] : planned.copies) {
    prepare_folder_of(folder / to);
    write_text_file(folder / to, read_text_file(from));
  }
  write_text_file(folder / "scene.toml", sweep.scene_text);
  write_text_file(folder / "manifest", manifest_of(sweep));
  write_text_file(folder / "sweep.json", sweep_text(sweep));
  return true;
}

}  // namespace taut::app
