#include "app/sweeps/sweep_run.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/figures/figures.hpp"
#include "app/frame_loop.hpp"
#include "app/output/csv.hpp"
#include "app/output/picture_record.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/output/run_report.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sewing/sewing.hpp"

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

constexpr int checkpoint_every = 60;

AttemptEnd end_named(const std::string& name) {
  return name == "done" ? AttemptEnd::done : name == "broken" ? AttemptEnd::broken : AttemptEnd::failed;
}

const char* name_of(AttemptEnd end) {
  return end == AttemptEnd::done ? "done" : end == AttemptEnd::broken ? "broken" : "failed";
}

/// The simulation of a run, at its start.
struct Loaded {
  DrawnScene scene;
  LoadedGarment garment;
  sim::Simulation simulation;

  static Loaded of(DrawnScene scene) {
    sew_and_load_bodies(scene);
    LoadedGarment garment = load_garment(scene);
    put_where_it_begins(garment, scene);
    sim::Simulation simulation = make_simulation(scene, garment);
    return {std::move(scene), std::move(garment), std::move(simulation)};
  }
};

// As `taut render` draws its last frame.
renderer::Image draw(Loaded& run) {
  const std::vector<sim::Vec3>& positions = run.simulation.state().current;
  const double time_s = run.simulation.state().time_s;
  if (is_fitted(run.scene)) {
    FittedView fitted(run.scene, run.simulation.garment());
    fitted.add(positions, run.garment.shown_m(positions), time_s);
    fitted.place_camera(run.scene);
  }
  OffscreenRenderer offscreen("auto");
  GarmentPainter painter(offscreen.renderer(), run.scene, run.simulation.garment(), run.simulation.pins().vertices,
                         drawn_colours(run.scene, run.garment));
  return painter.draw(positions, time_s);
}

class SweepRun {
 public:
  SweepRun(const Sweep& sweep, std::size_t run)
      : sweep_(sweep), run_(run), checkpoint_(sweep.file(run, ".checkpoint")) {
    saved_.scene_name = sweep.scene_hash(run) + ' ' + sweep.program;
  }

  Attempt go(const ProgressCallback& report) {
    Attempt attempt;
    try {
      attempt = simulate(report);
    } catch (const Interrupted&) {
      save();
      return {AttemptEnd::stopped, fmt::format("stopped after frame {}", saved_.frame)};
    } catch (const PromiseBroken& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const sim::Diverged& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const sim::ContactBlocked& error) {
      attempt = {AttemptEnd::broken, error.what()};
    } catch (const std::runtime_error& error) {
      attempt = {AttemptEnd::failed, error.what()};
    } catch (const std::bad_alloc&) {
      attempt = {AttemptEnd::failed, "not enough memory"};
    } catch (...) {
      save();  // another job has ended this one
      throw;
    }
    write(attempt);
    return attempt;
  }

 private:
  Attempt simulate(const ProgressCallback& report) {
    loaded_.emplace(Loaded::of(sweep_.scene(run_)));
    sim::Simulation& simulation = loaded_->simulation;
    const int frames = loaded_->scene.frames;
    if (!resume()) saved_.frame = go_to_start(loaded_->scene, simulation);
    FrameOutputs outputs;
    outputs.start_frame = saved_.frame;
    outputs.overlap = false;
    outputs.report = [&](const FrameRecord& record) {
      saved_.frame = record.frame;
      saved_.summary.add(record);
      if (record.frame % checkpoint_every == 0 && record.frame < frames) save();
      if (report) report(static_cast<double>(record.frame) / frames);
    };
    run_frames(simulation, frames, outputs);
    if (sweep_.pictures) {
      const std::vector<renderer::PngText> texts = {{"taut-sweep", sweep_.describe(run_)}};
      write_file(sweep_.file(run_, ".png"), renderer::encode_png(draw(*loaded_), texts));
    }
    const std::string excess = describe_excess(loaded_->scene, saved_.summary);
    const bool is_broken = !excess.empty() && !loaded_->scene.simulation.solver.bounded.allow_exceeding;
    return {is_broken ? AttemptEnd::broken : AttemptEnd::done, is_broken ? excess : ""};
  }

  /// Whether it goes on from where an earlier attempt at this very run stopped.
  bool resume() {
    if (std::error_code error; !std::filesystem::exists(checkpoint_, error)) return false;
    try {
      RunCheckpoint saved = read_run_checkpoint(checkpoint_);
      if (saved.scene_name != saved_.scene_name) return false;
      restore(checkpoint_, saved, loaded_->simulation);
      saved_ = std::move(saved);
      return true;
    } catch (const InputError&) {
      return false;  // damaged: the run begins anew
    }
  }

  void save() {
    if (loaded_ && saved_.summary.frames > 0) {
      saved_.simulation = sim::encode(loaded_->simulation.save(), loaded_->simulation.garment());
      write_run_checkpoint(checkpoint_, saved_);
    }
  }

  void write(const Attempt& attempt) {
    Json result = {{"index", run_},
                   {"values", sweep_.values(run_)},
                   {"scene", sweep_.scene_hash(run_)},
                   {"program", sweep_.program},
                   {"end", name_of(attempt.end)}};
    if (!attempt.what.empty()) result["where"] = attempt.what;
    if (loaded_ && saved_.summary.frames > 0) {
      result["vertices"] = loaded_->simulation.garment().mesh.positions.size();
      result["triangles"] = loaded_->simulation.garment().mesh.triangles.size();
      result["state_hash"] = hash_text(sim::hash(loaded_->simulation.state()));
      result.update(Json::parse(statistics_end(StatisticsFormat::json_lines, saved_.summary))["summary"]);
    }
    result["host"] = host_name();
    write_text_file(sweep_.file(run_, ".json"), result.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
  }

  const Sweep& sweep_;
  std::size_t run_;
  std::filesystem::path checkpoint_;
  RunCheckpoint saved_;
  std::optional<Loaded> loaded_;
};

/// The result of an earlier attempt that need not be tried again.
std::optional<Attempt> earlier(const Sweep& sweep, std::size_t run) {
  const std::optional<Json> result = result_of(sweep, run);
  return result && is_final(*result)
             ? std::optional(Attempt{end_named(result->value("end", "")), result->value("where", ""), false})
             : std::nullopt;
}

/// Removes what a process left half written that was killed at the run. Requires the run's lock; others may
/// be trying to take that.
void remove_unfinished(const Sweep& sweep, std::size_t run) {
  namespace fs = std::filesystem;
  const fs::path any = sweep.file(run, ".");
  std::vector<fs::path> unfinished;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(any.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    const bool is_of_run = name.starts_with(any.filename().string()) && name.find(".lock") == std::string::npos;
    if (is_of_run && name.find(".part-") != std::string::npos) unfinished.push_back(entry.path());
  }
  for (const fs::path& file : unfinished) fs::remove(file, ignored);
}

namespace fs = std::filesystem;

/// A lock on a whole file that others may not have. It belongs to the descriptor and ends with it, however its process
/// ends, also on a machine that shares the file.
struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

std::string text_in(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Where files cannot be locked everybody has the lock.
bool take(const Descriptor& file) {
  struct flock lock = whole_file();
  return ::fcntl(file.number(), F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

/// Whether the file is still there by its name: who had it before may have removed it meanwhile.
bool is_named(const Descriptor& file, const fs::path& name) {
  struct stat opened {
  }, named{};
  return ::fstat(file.number(), &opened) == 0 && ::stat(name.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
}

namespace fs = std::filesystem;

bool is_as_planned(const Sweep& sweep, std::size_t run, const Json& result) {
  return result.is_object() && result.value("index", most_runs) == run &&
         result.value("scene", "") == sweep.scene_hash(run) && result.value("program", "") == sweep.program;
}

/// How many files of the runs have this ending.
std::set<std::string> stems_of(const Sweep& sweep, const char* ending) {
  std::set<std::string> stems;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(sweep.folder / "runs", error)) {
    if (entry.path().extension() == ending) stems.insert(entry.path().stem().string());
  }
  return stems;
}

constexpr std::array measures = {"max_stretch",
                                 "max_surface_stretch",
                                 "max_p99_stretch",
                                 "max_p99_surface_stretch",
                                 "final_max_stretch",
                                 "frames_over_bound",
                                 "smallest_distance",
                                 "mean_substeps",
                                 "mean_sim_ms",
                                 "total_sim_ms",
                                 "final_rms_speed",
                                 "frames",
                                 "vertices",
                                 "triangles",
                                 "state_hash",
                                 "host",
                                 "where"};

/// Empty where the result does not say it.
std::string cell_of(const Json* result, const char* name) {
  const Json value = result != nullptr && result->contains(name) ? result->at(name) : Json();
  return value.is_null() ? "" : value.is_string() ? cell(value.get<std::string>()) : value.dump();
}

/// The values of a run that differ between runs.
std::string title_of(const Sweep& sweep, std::size_t run) {
  std::string title;
  const std::vector<std::size_t> choice = sweep.choice(run);
  for (std::size_t k = 0; k < choice.size(); ++k) {
    const SweepAxis& axis = sweep.axes[k];
    if (const Json& value = axis.values[choice[k]]; axis.values.size() > 1) {
      // Numbers do not say what they are.
      const std::string name = value.is_string() ? "" : axis.key.substr(axis.key.rfind('.') + 1) + ' ';
      title += (title.empty() ? "" : ", ") + name + value_label(value);
    }
  }
  return title;
}

renderer::Image read_picture(const std::filesystem::path& file) {
  const TextureImage image = decode_image(read_text_file(file));
  return {static_cast<int>(image.width_px), static_cast<int>(image.height_px), 4, *image.rgba};
}

std::size_t columns_of(const Sweep& sweep) {
  for (std::size_t k = sweep.axes.size(); k-- > 0;) {
    if (const std::size_t values = sweep.axes[k].values.size(); values > 1) {
      return std::min<std::size_t>(values, 10);
    }
  }
  return 1;
}

/// Hands out every run with its result, or null, in order.
void for_each_result(const Sweep& sweep, const std::function<void(std::size_t run, const Json* result)>& use) {
  for (std::size_t run = 0; run < sweep.runs(); ++run) {
    throw_if_interrupted();
    const std::optional<Json> result = result_of(sweep, run);
    use(run, result ? &*result : nullptr);
  }
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

Attempt attempt_run(const Sweep& sweep, std::size_t run, const ProgressCallback& report) {
  if (const auto there = earlier(sweep, run)) return *there;
  prepare_folder_of(sweep.file(run, ".json"));
  const RunLock lock(sweep.file(run, ".lock"));
  if (!lock.is_held()) return {AttemptEnd::busy, lock.owner() + " works on it"};
  remove_unfinished(sweep, run);
  // It may have come while this process waited for nothing but a file system.
  const auto there = earlier(sweep, run);
  return there ? *there : SweepRun(sweep, run).go(report);
}

void WorstEnd::add(AttemptEnd end) {
  const bool has_to_be_tried_again = end == AttemptEnd::stopped || end == AttemptEnd::busy;
  if (has_to_be_tried_again || code_ == exit_can_be_resumed) {
    code_ = exit_can_be_resumed;
  } else if (end == AttemptEnd::failed || code_ == exit_bad_input) {
    code_ = exit_bad_input;
  } else if (end == AttemptEnd::broken) {
    code_ = exit_promise_broken;
  }
}

void require_planned_program(const Sweep& sweep) {
  const std::string program = program_hash();
  if (program != sweep.program) {
    throw InputError(
        "'{}' was planned for the program {}, found {}; taut sweep plan again makes all runs anew with this "
        "one",
        sweep.folder.string(), sweep.program, program);
  }
}

RunLock::RunLock(fs::path file)
    : file_(std::move(file)), descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_.number() < 0) {
    throw InputError("cannot write '{}': {}", file_.string(), std::generic_category().message(errno));
  }
  is_held_ = take(descriptor_) && is_named(descriptor_, file_);
  owner_ = is_held_ ? host_name() + ' ' + std::to_string(::getpid()) : text_in(file_);
  if (is_held_ &&
      (::ftruncate(descriptor_.number(), 0) != 0 || ::write(descriptor_.number(), owner_.data(), owner_.size()) < 0)) {
    throw InputError("cannot write '{}': {}", file_.string(), std::generic_category().message(errno));
  }
}

RunLock::~RunLock() {
  std::error_code ignored;
  if (is_held_) fs::remove(file_, ignored);
}

bool RunLock::is_anybodys(const fs::path& file) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct flock lock = whole_file();
  return ::fcntl(opened.number(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

std::optional<Json> result_of(const Sweep& sweep, std::size_t run) {
  std::ifstream in(sweep.file(run, ".json"));
  Json result = in ? Json::parse(in, nullptr, false) : Json();
  return is_as_planned(sweep, run, result) ? std::optional(std::move(result)) : std::nullopt;
}

bool is_final(const Json& result) { return result.value("end", "") == "done" || result.value("end", "") == "broken"; }

SweepStatus status_of(const Sweep& sweep) {
  SweepStatus status;
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    const std::string end = result != nullptr ? result->value("end", "") : "";
    status.done += end == "done" ? 1 : 0;
    status.broken += end == "broken" ? 1 : 0;
    status.failed += end == "failed" ? 1 : 0;
    if (end == "failed" && status.first_failure.empty()) {
      status.first_failure = fmt::format("run {}: {}", run, result->value("where", ""));
    }
    if (result == nullptr || !is_final(*result)) status.missing.push_back(run);
  });
  std::set<std::string> locked = stems_of(sweep, ".lock");
  std::erase_if(locked,
                [&](const std::string& stem) { return !RunLock::is_anybodys(sweep.file(std::stoul(stem), ".lock")); });
  const std::set<std::string> saved = stems_of(sweep, ".checkpoint");
  status.working = locked.size();
  status.stopped = static_cast<std::size_t>(
      std::ranges::count_if(saved, [&](const std::string& stem) { return !locked.contains(stem); }));
  return status;
}

std::string ranges_text(std::span<const std::size_t> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text +=
        (text.empty() ? "" : ",") + std::to_string(numbers[i]) + (last > i ? '-' + std::to_string(numbers[last]) : "");
    i = last + 1;
  }
  return text;
}

std::string sweep_table(const Sweep& sweep) {
  std::vector<std::string> columns = {"index"};
  for (const SweepAxis& axis : sweep.axes) columns.push_back(cell(axis.key));
  columns.emplace_back("end");
  columns.insert(columns.end(), measures.begin(), measures.end());
  CsvTable table(columns);
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    std::vector<std::string> row = {std::to_string(run)};
    const Json values = sweep.values(run);
    for (const Json& value : values) row.push_back(cell(value_label(value)));
    row.push_back(result != nullptr ? cell_of(result, "end") : "missing");
    for (const char* name : measures) row.push_back(cell_of(result, name));
    table.add(std::move(row));
  });
  return table.text();
}

renderer::Image sweep_sheet(const Sweep& sweep) {
  const std::size_t step = (sweep.runs() + most_on_sheet - 1) / most_on_sheet;
  std::vector<DrawnFigure> pictures;
  for (std::size_t run = 0; run < sweep.runs(); run += step) {
    const std::filesystem::path file = sweep.file(run, ".png");
    if (std::error_code error; std::filesystem::exists(file, error)) {
      pictures.push_back({title_of(sweep, run), "", read_picture(file)});
    }
  }
  if (pictures.empty()) return {};
  // Where some are missing, what is there fills up.
  const std::size_t columns = step == 1 ? columns_of(sweep) : 10;
  return contact_sheet(pictures, 1.0F, {.columns = static_cast<int>(columns), .cell_px = 400, .title_px = 16.0F});
}

}  // namespace taut::app
