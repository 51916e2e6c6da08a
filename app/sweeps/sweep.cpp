#include "app/sweeps/sweep.hpp"

#include <fstream>

#include "app/base/json_reading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/frame_loop.hpp"
#include "app/output/csv.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/output/run_report.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sewing/sewing.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array end_names = {"done", "broken", "failed"};
constexpr int checkpoint_every = 60;

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string program_hash() { return hash_text(sim::fnv1a(sim::fnv1a_of_nothing, read_text_file("/proc/self/exe", max_model_bytes))); }

using FileHashes = std::map<fs::path, std::uint64_t>;

/// Adds the content of all files that a value names by their full paths, and of what belongs to them.
void add_files(const Json& value, FileHashes& known, std::uint64_t& hash) {
  for (const Json& item : value.is_structured() ? value : Json::array()) add_files(item, known, hash);
  const fs::path named = value.is_string() ? value.get<std::string>() : "";
  for (const char* ending : {"", ".landmarks.toml", ".mtl", ".bin"}) {
    fs::path file = named;
    if (*ending != '\0') file.replace_extension(ending);
    std::error_code error;
    if (!named.is_absolute() || !fs::is_regular_file(file, error)) continue;
    const auto [content, is_new] = known.try_emplace(file, sim::fnv1a_of_nothing);
    if (is_new) content->second = sim::fnv1a(content->second, read_text_file(file, max_model_bytes));
    hash = sim::fnv1a(hash, hash_text(content->second));
  }
}

std::string scene_hash(const std::string& text, FileHashes& known) {
  std::uint64_t hash = sim::fnv1a(sim::fnv1a_of_nothing, text);
  add_files(json_of(read_toml_text(text, "scene")), known, hash);
  return hash_text(hash);
}

/// A key of the scene and the values that it takes.
struct Axis {
  std::string key;
  const toml::array* values;
};

/// Keys may stand in quotes, "wind.speed", or without, which TOML reads as tables in tables.
void read_axes(const toml::table& table, const std::string& section, const Source& source, std::vector<Axis>& axes) {
  for (const auto& [name, node] : entries_of(table)) {
    const std::string key = section + name;
    if (const toml::table* inner = node->as_table()) {
      read_axes(*inner, key + '.', source, axes);
      continue;
    }
    axes.push_back({key, node->as_array()});
    if (axes.back().values == nullptr || axes.back().values->empty()) {
      fail(source, line_of(*node), key + ": found " + to_text(*node) + ", expected a list of values");
    }
  }
}

struct Study {
  std::string scene;
  int frames = 0;  ///< 0: as the scene has it
  std::vector<Axis> axes;
  std::size_t runs = 0;
};

Study read_study(const toml::table& table, const Source& source) {
  static const std::vector<Key<Study>> keys = {
      text_key<Study>("scene", MEMBER(scene), "what every run begins as"),
      whole_key<Study>("frames", {1, 1000000}, MEMBER(frames), "length of every run")};
  const toml::table* axes = table["axes"].as_table();
  if (axes == nullptr) fail(source, 0, "expected a table [axes], such as \"wind.speed\" = [0, 1, 10]");
  Study study;
  for (const auto& [key, value] : entries_of(table)) {
    if (key != "axes") KeyReader(keys, source, study).read_value(key, *value);
  }
  if (study.scene.empty()) fail(source, 0, "expected scene = \"...\", a scene or a garment file");
  read_axes(*axes, "", source, study.axes);
  double runs = 1.0;
  for (const Axis& axis : study.axes) runs *= static_cast<double>(axis.values->size());
  if (runs > static_cast<double>(most_runs)) {
    fail(source, 0, fmt::format("the axes make {:.0f} runs, expected at most {}", runs, most_runs));
  }
  study.runs = static_cast<std::size_t>(runs);
  return study;
}

Json plan_of(const Sweep& sweep) {
  Json runs = Json::array();
  for (const PlannedRun& run : sweep.runs) runs.push_back({{"values", run.values}, {"hash", run.hash}});
  return {{"program", sweep.program}, {"runs", runs}};
}

/// Requires that the folder holds no sweep of other values.
void require_own_folder(const Sweep& sweep) {
  std::error_code error;
  if (!fs::exists(sweep.folder / "sweep.json", error)) return;
  const Sweep there = read_sweep(sweep.folder);
  const auto same = [](const PlannedRun& a, const PlannedRun& b) { return a.values == b.values; };
  if (!std::equal(there.runs.begin(), there.runs.end(), sweep.runs.begin(), sweep.runs.end(), same)) {
    throw InputError("'{}' holds the sweep of another study; choose another folder, or remove it",
                     sweep.folder.string());
  }
}

/// A run that is being made.
class SweepRun {
 public:
  SweepRun(const Sweep& sweep, std::size_t run) : sweep_(sweep), run_(run) {
    saved_.scene_name = sweep.runs[run].hash + ' ' + sweep.program;
  }

  Attempt go(const ProgressCallback& report) {
    Attempt attempt;
    try {
      attempt = simulate(report);
    } catch (const Interrupted&) {
      save();
      return {RunEnd::stopped};
    } catch (const PromiseBroken& error) {
      attempt = {RunEnd::broken, error.what()};
    } catch (const sim::Diverged& error) {
      attempt = {RunEnd::broken, error.what()};
    } catch (const std::runtime_error& error) {
      attempt = {RunEnd::failed, error.what()};
    } catch (const std::bad_alloc&) {
      attempt = {RunEnd::failed, "not enough memory"};
    } catch (...) {
      save();  // another job has ended this one
      throw;
    }
    write(attempt);
    return attempt;
  }

 private:
  Attempt simulate(const ProgressCallback& report) {
    const fs::path file = sweep_.file(run_, ".toml");
    DrawnScene scene = read_scene_file(file);
    scene.name = file.stem().string();
    sew_and_load_bodies(scene);
    LoadedGarment garment = load_garment(scene);
    put_where_it_begins(garment, scene);
    simulation_.emplace(make_simulation(scene, garment));
    if (!resume()) saved_.frame = go_to_start(scene, *simulation_);
    FrameOutputs outputs;
    outputs.start_frame = saved_.frame;
    outputs.overlap = false;
    outputs.report = [&](const FrameRecord& record) {
      saved_.frame = record.frame;
      saved_.summary.add(record);
      if (record.frame % checkpoint_every == 0 && record.frame < scene.frames) save();
      if (report) report(static_cast<double>(record.frame) / scene.frames);
    };
    run_frames(*simulation_, scene.frames, outputs);
    const std::string excess = describe_excess(scene, saved_.summary);
    const bool is_broken = !excess.empty() && !scene.simulation.solver.bounded.allow_exceeding;
    return {is_broken ? RunEnd::broken : RunEnd::done, is_broken ? excess : ""};
  }

  /// Whether it goes on from where an earlier attempt at this very run stopped.
  bool resume() {
    const fs::path checkpoint = sweep_.file(run_, ".checkpoint");
    try {
      RunCheckpoint saved = read_run_checkpoint(checkpoint);
      if (saved.scene_name != saved_.scene_name) return false;
      restore(checkpoint, saved, *simulation_);
      saved_ = std::move(saved);
      return true;
    } catch (const InputError&) {
      return false;  // there is none, or it is damaged: the run begins anew
    }
  }

  void save() {
    if (simulation_ && saved_.summary.frames > 0) {
      saved_.simulation = sim::encode(simulation_->save(), simulation_->garment());
      write_run_checkpoint(sweep_.file(run_, ".checkpoint"), saved_);
    }
  }

  void write(const Attempt& attempt) {
    Json result = {{"index", run_},
                   {"values", sweep_.runs[run_].values},
                   {"hash", sweep_.runs[run_].hash},
                   {"program", sweep_.program},
                   {"end", end_names.at(static_cast<std::size_t>(attempt.end))}};
    if (!attempt.reason.empty()) result["reason"] = attempt.reason;
    if (simulation_ && saved_.summary.frames > 0) {
      result["vertices"] = simulation_->garment().mesh.positions.size();
      result["triangles"] = simulation_->garment().mesh.triangles.size();
      result["state_hash"] = hash_text(sim::hash(simulation_->state()));
      result.update(summary_json(saved_.summary));
    }
    write_text_file(sweep_.file(run_, ".json"), result.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
    std::error_code ignored;
    fs::remove(sweep_.file(run_, ".checkpoint"), ignored);
  }

  const Sweep& sweep_;
  std::size_t run_;
  RunCheckpoint saved_;
  std::optional<sim::Simulation> simulation_;
};

RunEnd end_of(const Json& result) {
  const auto* const name = std::ranges::find(end_names, result.value("end", "failed"));
  return static_cast<RunEnd>(std::min<std::ptrdiff_t>(name - end_names.begin(), 2));
}

/// A value as a cell; a file by its name without folder and ending.
std::string value_cell(const Json& value) {
  return cell(value.is_string() ? fs::path(value.get<std::string>()).stem().string() : toml_text(value));
}

std::string cell_of(const Json& result, const std::string& name) {
  const Json value = result.value(name, Json());
  return value.is_null() ? "" : value.is_string() ? cell(value.get<std::string>()) : value.dump();
}

}  // namespace

fs::path Sweep::file(std::size_t run, const char* ending) const {
  return folder / "runs" / fmt::format("{:06}{}", run, ending);
}

Sweep plan_sweep(const fs::path& file, const fs::path& folder) {
  const Source source{file.string(), false};
  const toml::table table = read_toml_text(read_text_file(file), source.name);
  const Study study = read_study(table, source);
  const fs::path beside_study = file.parent_path() / study.scene;
  DrawnScene base = find_scene(fs::is_regular_file(beside_study) ? beside_study.string() : study.scene, {});
  base.frames = study.frames > 0 ? study.frames : base.frames;
  if (!base.checkpoint.empty()) base.checkpoint = fs::absolute(base.checkpoint);

  const SceneFormat<DrawnScene> format = drawn_scene_format();
  Sweep sweep{folder, program_hash(), {}};
  std::vector<std::string> scenes;
  FileHashes known;
  for (std::size_t k = 0; k < study.runs; ++k) {
    throw_if_interrupted();
    DrawnScene scene = base;
    std::vector<KeyValue> values;
    PlannedRun& run = sweep.runs.emplace_back();
    std::size_t stride = study.runs;  // the last axis changes fastest
    for (const Axis& axis : study.axes) {
      const std::size_t all = stride;
      stride /= axis.values->size();
      const toml::node& value = (*axis.values)[k % all / stride];
      values.push_back({axis.key, &value, source});
      run.values[axis.key] = json_of(value);
    }
    set_values(format, values, scene);
    scenes.push_back(scene_text(scene, GarmentNaming::full_path));
    run.hash = scene_hash(scenes.back(), known);
  }
  require_own_folder(sweep);
  prepare_folder_of(sweep.file(0, ".toml"));
  for (std::size_t run = 0; run < scenes.size(); ++run) write_text_file(sweep.file(run, ".toml"), scenes[run]);
  write_text_file(folder / "sweep.json", plan_of(sweep).dump(1) + '\n');
  return sweep;
}

Sweep read_sweep(const fs::path& folder) {
  const fs::path file = folder / "sweep.json";
  if (std::error_code error; !fs::exists(file, error)) {
    throw InputError("'{}' is no sweep: there is no sweep.json; taut sweep plan makes one", folder.string());
  }
  try {
    const auto json = parse_json<Json>(read_text_file(file), "cannot read the sweep in '" + folder.string() + '\'',
                                       "what taut sweep plan writes");
    Sweep sweep{folder, json.at("program"), {}};
    for (const Json& run : json.at("runs")) sweep.runs.push_back({run.at("values"), run.at("hash")});
    if (sweep.runs.empty()) throw InputError("'{}' names no run", file.string());
    return sweep;
  } catch (const Json::exception& error) {
    throw InputError("cannot read the sweep in '{}': {}", folder.string(), plain_reason(error));
  }
}

void require_planned_program(const Sweep& sweep) {
  if (const std::string program = program_hash(); program != sweep.program) {
    throw InputError("'{}' was planned for the program {}, found {}; taut sweep plan again makes all runs anew",
                     sweep.folder.string(), sweep.program, program);
  }
}

Attempt attempt_run(const Sweep& sweep, std::size_t run, const ProgressCallback& report) {
  if (const std::optional<Json> there = result_of(sweep, run); there && end_of(*there) != RunEnd::failed) {
    return {end_of(*there), there->value("reason", "")};
  }
  FileHashes known;
  if (const fs::path scene = sweep.file(run, ".toml");
      scene_hash(read_text_file(scene), known) != sweep.runs[run].hash) {
    throw InputError("'{}' or a file that it names is not as it was planned; taut sweep plan again makes the run anew",
                     scene.string());
  }
  return SweepRun(sweep, run).go(report);
}

std::optional<Json> result_of(const Sweep& sweep, std::size_t run) {
  const fs::path file = sweep.file(run, ".json");
  if (std::error_code error; !fs::exists(file, error)) return std::nullopt;
  try {
    auto result = parse_json<Json>(read_text_file(file), "", "");
    const bool is_as_planned = result.is_object() && result.value("hash", "") == sweep.runs[run].hash &&
                               result.value("program", "") == sweep.program;
    return is_as_planned ? std::optional(std::move(result)) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;  // it was cut off
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

SweepStatus status_of(const Sweep& sweep) {
  SweepStatus status;
  for (std::size_t run = 0; run < sweep.runs.size(); ++run) {
    const std::optional<Json> result = result_of(sweep, run);
    const RunEnd end = result ? end_of(*result) : RunEnd::failed;
    if (result) ++status.ended.at(static_cast<std::size_t>(end));
    if (end == RunEnd::failed) status.missing.push_back(run);
    if (result && end == RunEnd::failed && status.first_failure.empty()) {
      status.first_failure = fmt::format("run {}: {}", run, result->value("reason", ""));
    }
  }
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
  for (const auto& [key, value] : sweep.runs.front().values.items()) columns.push_back(cell(key));
  std::vector<std::string> measures = {"end"};
  const Json summary = summary_json({});
  for (const auto& [name, value] : summary.items()) measures.push_back(name);
  measures.insert(measures.end(), {"vertices", "triangles", "state_hash", "reason"});
  columns.insert(columns.end(), measures.begin(), measures.end());
  CsvTable table(columns);
  for (std::size_t run = 0; run < sweep.runs.size(); ++run) {
    const Json result = result_of(sweep, run).value_or(Json{{"end", "missing"}});
    std::vector<std::string> row = {std::to_string(run)};
    for (const Json& value : sweep.runs[run].values) row.push_back(value_cell(value));
    for (const std::string& name : measures) row.push_back(cell_of(result, name));
    table.add(std::move(row));
  }
  return table.text();
}

}  // namespace taut::app
