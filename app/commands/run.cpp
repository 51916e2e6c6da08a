#include "app/commands/run.hpp"

#include <future>

#include "app/bodies/body_loading.hpp"
#include "app/drawing/inspection_picture.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/mending/following_limits.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::app {
namespace {

std::filesystem::path folder_beside(const std::string& pattern, int frame) {
  const std::filesystem::path name = pattern;
  const bool is_sequence = pattern.find('{') != std::string::npos;
  return is_sequence ? OutputPattern(pattern, name.extension().string()).path_of(frame).parent_path() : "";
}

}  // namespace

SceneRun::SceneRun(const RunOptions& asked_options, DrawnScene asked, std::FILE* remarks_to,
                   std::string why_model_is_not_shown)
    : options(asked_options),
      // An earlier run has printed them.
      remarks(why_model_is_not_shown.empty() ? remarks_to : nullptr),
      why_not_model(std::move(why_model_is_not_shown)),
      scene(std::move(asked)),
      progress(scene.name) {
  bodies = sew_and_load_bodies(scene, options.overrides, [this](const std::string& stage) { progress.begin(stage); });
  progress.hide();
  print_body_remarks(scene, bodies.remarks, remarks);
}

void SceneRun::require_outputs(const ExportSettings& settings, std::vector<std::filesystem::path> others,
                               std::vector<std::filesystem::path> claimed) {
  files_written = std::move(others);
  if (!options.shapes.empty()) {
    const std::vector<std::filesystem::path> exported = require_export(settings);
    files_written.insert(files_written.end(), exported.begin(), exported.end());
    claimed.emplace_back(settings.name);
  }
  if (!options.statistics.empty()) {
    statistics_format(options.statistics);
    prepare_parent_folder(options.statistics);
    files_written.push_back(options.statistics);
    claimed.push_back(options.statistics);
  }
  require_inputs_kept(files_written, scene, bodies.files_read);
  for (const std::filesystem::path& name : claimed) claims.emplace_back(name);
}

void SceneRun::load(const std::function<void()>& meanwhile) {
  const auto read = [this] { return load_garment(scene, [this](const std::string& stage) { progress.begin(stage); }); };
  std::future<LoadedGarment> garment = std::async(meanwhile ? std::launch::async : std::launch::deferred, read);
  if (meanwhile) meanwhile();
  loaded = garment.get();
  require_inputs_kept(files_written, scene, loaded.files_read);
  progress.hide();
  print_body_remarks(scene, put_where_it_begins(loaded, scene, bodies), remarks);
  if (remarks != nullptr) print_remarks(scene, loaded, bodies.all, remarks);
  simulation.emplace(make_simulation(scene, loaded, bodies.all));
  if (!why_not_model.empty()) show_simulated(loaded);
}

int SceneRun::begin() {
  const int frame =
      go_to_start(scene, bodies, *simulation, [this](const std::string& stage) { progress.begin(stage); });
  const std::string crossings = options.verify ? verifier.begin(*simulation) : "";
  // Without a checkpoint, load() has already reported the crossings.
  if (prints_messages && !scene.checkpoint.empty() && !crossings.empty()) {
    fmt::print("{}: at the start {}\n", scene.name, crossings);
  }
  return frame;
}

void SceneRun::open_statistics(const RunDescription& description, std::optional<int> last_kept) {
  if (!options.statistics.empty()) statistics.emplace(options.statistics, description, last_kept);
}

std::vector<FrameRecord> SceneRun::go(int last_frame, const std::string& pattern, OffscreenRenderer* offscreen) {
  if (shapes) {
    outputs.write_shape = [this](int frame, const auto& /*moment*/, const auto& shown_m) {
      shapes->write(frame, shown_m);
    };
  }
  if (loaded.following && (shapes || outputs.draw || prints_messages)) {
    outputs.show = [this](std::span<const sim::Vec3> positions_m) {
      std::vector<sim::Vec3> shown_m = loaded.shown_m(positions_m);
      // Crossings are counted for messages alone.
      const sim::Stretch stretch = prints_messages ? following.add(*loaded.following, shown_m)
                                                   : loaded.following->shape_limits->measure_stretch(shown_m);
      if (may_reject_model && (shapes || outputs.draw)) require_fit_to_show(stretch);
      return shown_m;
    };
  }
  if (options.verify) {
    outputs.verify = [this](const auto& moment, FrameRecord& record) { return verifier.check(moment, record); };
  }
  const auto end_early = [this] {
    progress.hide();
    if (on_early_end) on_early_end();
    const std::string written = finish_shapes();
    fmt::print("{}", prints_messages ? written : "");
  };
  try {
    return run_frames(*simulation, last_frame, outputs);
  } catch (const FrameBlocked& error) {
    end_early();
    end_blocked(error, scene, *simulation, pattern, offscreen);
  } catch (const std::exception& error) {
    if (is_any<PromiseBroken, sim::Diverged>(error)) end_early();
    if (is_any<Interrupted>(error)) {
      progress.hide();
      if (on_early_end) on_early_end();
    }
    throw;
  }
}

std::string SceneRun::describe_shown() const {
  return why_not_model.empty() ? following.describe() : describe_simulated_shown(why_not_model);
}

int run_showing_what_fits(const std::function<int(const std::string& why_not_model)>& run) {
  std::string reason;
  try {
    return run("");
  } catch (const ModelOverstretched& error) {
    reason = error.what();
  }
  fmt::print(stderr, "taut: {}: begins again and shows the simulated mesh\n", reason);
  return run(reason);
}

void prepare_png(const std::filesystem::path& file) {
  if (file.extension() != ".png") throw UsageError("--output " + file.string() + ": expected a name that ends in .png");
  prepare_parent_folder(file);
}

void end_blocked(const FrameBlocked& error, const DrawnScene& scene, const sim::Simulation& simulation,
                 const std::string& pattern, OffscreenRenderer* offscreen) {
  std::string shown;
  try {
    const std::filesystem::path file = free_name(folder_beside(pattern, error.frame), "blocked", ".png");
    prepare_parent_folder(file);
    std::optional<OffscreenRenderer> own;
    if (offscreen == nullptr) offscreen = &own.emplace("auto");
    write_file(file, renderer::encode_png(
                         draw_blocked(offscreen->renderer(), scene, simulation, error.blocked, error.what())));
    shown = fmt::format("'{}' shows where, in the frame before", file.string());
  } catch (const std::exception& reason) {
    shown = fmt::format("there is no picture of it: {}", reason.what());
  }
  throw PromiseBroken("{}; {}; solver.allow_exceeding = \"contact\" goes on all the same", error.what(), shown);
}

}  // namespace taut::app
