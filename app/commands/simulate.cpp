#include "app/commands/run.hpp"
#include "app/models/model_fitting.hpp"
#include "app/output/run_checkpoint.hpp"

namespace taut::app {
namespace {

/// A line for every frame in the range; of frames in which the cloth sleeps one that says so.
class FrameLines {
 public:
  explicit FrameLines(FrameRange range) : range_(range) {}

  void print(const FrameRecord& record) {
    const bool is_said = record.asleep && sleep_is_said_;
    if (!range_.contains(record.frame) || is_said) return;
    sleep_is_said_ = record.asleep;
    fmt::print(
        "frame {:5}  time {:8.4f} s  max stretch {:8.4f} %  p99 {:8.4f} %  surface {:8.4f} %  p99 {:8.4f} %  "
        "rms speed {:9.6f} m/s{}\n",
        record.frame, record.time_s, 100.0 * record.stretch.max, 100.0 * record.stretch.p99,
        100.0 * record.surface_stretch.max, 100.0 * record.surface_stretch.p99, record.rms_speed_m_per_s,
        record.asleep ? "  asleep, no more lines until it wakes" : "");
    // Whoever reads it through a pipe sees it now and not when the run is over.
    std::fflush(stdout);
  }

 private:
  FrameRange range_;
  bool sleep_is_said_ = false;
};

void print_summary(const RunSummary& summary) {
  fmt::print(
      "{}, {:.2f} ms of processor time each; largest stretch {:.4f} % (frame {}), at the end {:.4f} %; of "
      "the surface {:.4f} % (frame {}), at the end {:.4f} %{}{}\n",
      counted(summary.frames, "frame"), summary.mean_sim_ms(), 100.0 * summary.max_stretch, summary.max_stretch_frame,
      100.0 * summary.final_max_stretch, 100.0 * summary.max_surface_stretch, summary.max_surface_stretch_frame,
      100.0 * summary.final_max_surface_stretch,
      summary.asleep_since_frame < 0 ? "" : fmt::format("; at rest since frame {}", summary.asleep_since_frame),
      describe_crossings(summary).empty() ? "" : "; " + describe_crossings(summary));
}

/// The run as it begins or goes on; puts the simulation there.
RunCheckpoint begin(const SimulateOptions& options, SceneRun& run) {
  RunCheckpoint begun;
  if (!options.resume.empty()) {
    if (options.verify) {
      run.verifier.begin(*run.simulation);  // where the run began, which is not where it goes on
    }
    begun = read_run_checkpoint(options.resume);
    require_same_scene(options.resume, begun, run.scene.name, scene_text(run.scene));
    restore(options.resume, begun, *run.simulation);
  } else {
    begun.scene_name = run.scene.name;
    begun.scene = scene_text(run.scene);
    begun.frame = run.begin();
  }
  return begun;
}

/// A run under way.
struct Running {
  const SimulateOptions& options;
  SceneRun& run;
  FrameLines lines;
  RunCheckpoint saved;
  int last_frame = 0;
  int first_frame = saved.frame;
  Stopwatch since_start = Stopwatch();

  /// Counts, files and messages of a frame, as it comes.
  void report(const FrameRecord& record) {
    saved.frame = record.frame;
    saved.summary.add(record);
    if (run.statistics) run.statistics->add(record);
    if (options.json) fmt::print("{}", statistics_line(StatisticsFormat::json_lines, record));
    if (run.is_told) {
      run.progress.hide();
      lines.print(record);
    }
    if (record.frame % options.checkpoint_every == 0) save();
    run.progress.begin(
        fmt::format("frame {} of {}{}", record.frame + 1, last_frame,
                    time_left(1e-3 * since_start.elapsed_ms(), record.frame - first_frame, last_frame - first_frame)));
  }

  void save() {
    if (!options.saved_to().empty()) {
      if (run.shapes) run.shapes->keep();
      saved.simulation = sim::encode(run.simulation->save(), run.simulation->garment());
      write_run_checkpoint(options.saved_to(), saved);
    }
  }

  /// Saves the run and says how it goes on. Returns the exit code.
  int stop() {
    save();
    run.progress.hide();
    std::fflush(stdout);
    fmt::print(stderr, "taut: stopped after frame {0}, saved in '{1}': the same command with --resume {1} goes on\n",
               saved.frame, options.saved_to().string());
    return exit_can_be_resumed;
  }

  /// The end of a run: said, printed for programs, written. Returns the exit code.
  int finish() {
    run.progress.hide();
    save();
    const std::string written = run.finish_shapes();
    if (run.is_told) {
      print_summary(saved.summary);
      fmt::print("{}", written);
    }
    if (options.json) fmt::print("{}", statistics_end(StatisticsFormat::json_lines, saved.summary));
    if (run.statistics) {
      run.statistics->finish(saved.summary);
      fmt::print("{}", run.is_told ? "wrote " + options.statistics.string() + '\n' : "");
    }
    if (run.is_told) {
      const std::string following = describe_following(run.loaded, run.simulation->state().current);
      fmt::print("{}{}", following.empty() ? "" : following + '\n',
                 options.verify ? run.verifier.summary() + '\n' : "");
    }
    return judge_bound(run.scene, saved.summary);
  }
};

}  // namespace

int run(const SimulateOptions& options) {
  SceneRun run(options, find_scene(options.scene, options.overrides),
               options.quiet  ? nullptr
               : options.json ? stderr
                              : stdout);
  run.is_told = !options.quiet && !options.json;
  const FrameRange range = options.frames.empty()
                               ? FrameRange{1, run.scene.frames}
                               : frame_range(options.frames, run.scene.frames,
                                             is_clip(options.shapes) ? NumberMeans::count : NumberMeans::frame);
  ExportSettings exported = {.name = options.shapes,
                             .frames = range,
                             .frame_rate_hz = run.scene.simulation.frame_rate_hz,
                             .can_be_resumed = !options.saved_to().empty(),
                             .look = run.scene.picture.cloth};
  if (!options.resume.empty()) run.scene.files_read.push_back(options.resume);
  std::vector<std::filesystem::path> saved;
  if (!options.saved_to().empty()) saved.push_back(options.saved_to());
  for (const std::filesystem::path& file : saved) prepare_folder_of(file);
  std::error_code error;
  const bool goes_on_in_place =
      !options.resume.empty() && (options.saved_to() == options.resume ||
                                  std::filesystem::equivalent(options.saved_to(), options.resume, error));
  run.require_outputs(exported, goes_on_in_place ? std::vector<std::filesystem::path>{} : saved, saved);
  run.load();
  run.progress.begin("frame 1");
  Running running{options, run, FrameLines(range), begin(options, run), range.last};
  const int begun = running.first_frame;
  require_begun(begun, range.last);
  const RunDescription description = {run.scene, run.simulation->garment(), run.simulation->pins().vertices.size(), "",
                                      options.verify};
  // A run that was stopped before its first frame has written nothing to go on with.
  const bool is_resumed = !options.resume.empty() && running.saved.summary.frames > 0;
  run.open_statistics(description, is_resumed ? std::optional(begun) : std::nullopt);
  if (options.json) fmt::print("{}", statistics_header(StatisticsFormat::json_lines, description));
  if (!options.shapes.empty()) {
    exported.frames.first = std::max(range.first, is_resumed ? start_frame(run.scene) : begun);
    exported.last_kept = is_resumed ? std::optional(begun) : std::nullopt;
    run.shapes = open_sink(exported, run.loaded, run.simulation->state().current);
  }
  run.outputs.start_frame = begun;
  run.outputs.with_start = !is_resumed && range.first <= begun;
  const bool is_read = !options.quiet || options.json || run.statistics || !options.saved_to().empty();
  run.outputs.measured = is_read ? Measured::all : Measured::promises;
  run.outputs.report = [&](const FrameRecord& record) { running.report(record); };
  try {
    run.go(range.last, options.shapes, nullptr);
  } catch (const Interrupted&) {
    if (options.saved_to().empty()) throw;
    return running.stop();
  }
  return running.finish();
}

}  // namespace taut::app
