#include "app/commands/run.hpp"
#include "app/runs/run_checkpoint.hpp"

namespace taut::app {
namespace {

void print_line(const FrameRecord& record) {
  fmt::print(
      "frame {:5}  time {:8.4f} s  max stretch {:8.4f} %  p99 {:8.4f} %  surface {:8.4f} %  p99 {:8.4f} %  "
      "rms speed {:9.6f} m/s{}\n",
      record.frame, record.time_s, 100.0 * record.stretch.max, 100.0 * record.stretch.p99,
      100.0 * record.surface_stretch.max, 100.0 * record.surface_stretch.p99, record.rms_speed_m_per_s,
      record.asleep ? "  asleep, no more lines until it wakes" : "");
  // Shows the line at once to a program that reads it through a pipe.
  std::fflush(stdout);
}

void print_summary(const RunSummary& summary) {
  fmt::print(
      "{}, {:.2f} ms of processor time each; largest stretch {:.4f} % (frame {}), at the end {:.4f} %; of "
      "the surface {:.4f} % (frame {}), at the end {:.4f} %{}{}\n",
      count_text(summary.frames, "frame"), summary.mean_sim_ms(), 100.0 * summary.max_stretch,
      summary.max_stretch_frame, 100.0 * summary.final_max_stretch, 100.0 * summary.max_surface_stretch,
      summary.max_surface_stretch_frame, 100.0 * summary.final_max_surface_stretch,
      summary.asleep_since_frame < 0 ? "" : fmt::format("; at rest since frame {}", summary.asleep_since_frame),
      describe_crossings(summary).empty() ? "" : "; " + describe_crossings(summary));
}

/// Moves the simulation to the start of the run, or to the checkpoint it resumes from. Returns the state of the run
/// there.
RunCheckpoint begin(const SimulateOptions& options, SceneRun& run) {
  RunCheckpoint begun;
  if (!options.resume.empty()) {
    if (options.verify) {
      run.verifier.begin(*run.simulation);  // compares with the run's first start, not with the checkpoint
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

/// State of a run.
struct Running {
  const SimulateOptions& options;
  SceneRun& run;
  FrameRange range;  ///< frames that have lines
  int& last_said;    ///< last frame with a line, also of an earlier run of the same frames; -1: none
  RunCheckpoint saved;
  int first_frame = saved.frame;
  bool sleep_is_said = false;
  Stopwatch since_start = Stopwatch();

  /// Adds the frame to the counts, files and messages.
  void report(const FrameRecord& record) {
    saved.frame = record.frame;
    saved.summary.add(record);
    if (run.statistics) run.statistics->add(record);
    const bool is_new = record.frame > last_said;
    last_said = std::max(last_said, record.frame);
    if (options.json && is_new) fmt::print("{}", statistics_line(StatisticsFormat::json_lines, record));
    if (run.prints_messages) {
      run.progress.hide();
      if (range.contains(record.frame) && is_new && !(record.asleep && sleep_is_said)) {
        print_line(record);
        sleep_is_said = record.asleep;
      }
    }
    if (record.frame % options.checkpoint_every == 0) save();
    run.progress.begin(
        fmt::format("frame {} of {}{}", record.frame + 1, range.last,
                    time_left(1e-3 * since_start.elapsed_ms(), record.frame - first_frame, range.last - first_frame)));
  }

  void save() {
    if (!options.checkpoint_file().empty()) {
      if (run.shapes) run.shapes->save_frames();
      saved.simulation = sim::encode(run.simulation->save(), run.simulation->garment());
      write_run_checkpoint(options.checkpoint_file(), saved);
    }
  }

  /// Saves the run and prints how to resume it. Returns the exit code.
  int stop() {
    save();
    run.progress.hide();
    std::fflush(stdout);
    fmt::print(stderr, "taut: stopped after frame {0}, saved in '{1}': the same command with --resume {1} goes on\n",
               saved.frame, options.checkpoint_file().string());
    return exit_can_be_resumed;
  }

  /// Completes the outputs and prints the summary. Returns the exit code.
  int finish() {
    run.progress.hide();
    save();
    const std::string written = run.finish_shapes();
    if (run.prints_messages) {
      print_summary(saved.summary);
      fmt::print("{}", written);
    }
    if (options.json) fmt::print("{}", statistics_end(StatisticsFormat::json_lines, saved.summary));
    if (run.statistics) {
      run.statistics->finish(saved.summary);
      fmt::print("{}", run.prints_messages ? "wrote " + options.statistics.string() + '\n' : "");
    }
    if (run.prints_messages) {
      const std::string shown = run.describe_shown();
      fmt::print("{}{}", shown.empty() ? "" : shown + '\n', options.verify ? run.verifier.summary() + '\n' : "");
    }
    return judge_bound(run.scene, saved.summary);
  }
};

int simulate(const SimulateOptions& options, const std::string& why_not_model, int& last_said) {
  SceneRun run(options, find_scene(options.scene, options.overrides),
               options.quiet  ? nullptr
               : options.json ? stderr
                              : stdout,
               why_not_model);
  run.prints_messages = !options.quiet && !options.json;
  const FrameRange range = options.frames.empty()
                               ? FrameRange{1, run.scene.frames}
                               : frame_range(options.frames, run.scene.frames,
                                             is_clip(options.shapes) ? NumberMeans::count : NumberMeans::frame);
  ExportSettings exported = {.name = options.shapes,
                             .frames = range,
                             .frame_rate_hz = run.scene.simulation.frame_rate_hz,
                             .can_be_resumed = !options.checkpoint_file().empty(),
                             .look = run.scene.picture.cloth};
  // Frames that an earlier run has written keep their faces.
  run.may_reject_model = !exported.can_be_resumed;
  if (!options.resume.empty()) run.scene.files_read.push_back(options.resume);
  std::vector<std::filesystem::path> saved;
  if (!options.checkpoint_file().empty()) {
    prepare_parent_folder(saved.emplace_back(options.checkpoint_file()));
  }
  std::error_code error;
  const bool goes_on_in_place =
      !options.resume.empty() && (options.checkpoint_file() == options.resume ||
                                  std::filesystem::equivalent(options.checkpoint_file(), options.resume, error));
  run.require_outputs(exported, goes_on_in_place ? std::vector<std::filesystem::path>{} : saved, saved);
  run.load();
  run.progress.begin("frame 1");
  Running running{options, run, range, last_said, begin(options, run)};
  const int begun = running.first_frame;
  require_not_before_start(begun, range.last);
  const RunDescription description = {run.scene, run.simulation->garment(), run.simulation->pins().vertices.size(), "",
                                      options.verify};
  // A run that was stopped before its first frame has written nothing to continue.
  const bool is_resumed = !options.resume.empty() && running.saved.summary.frames > 0;
  run.open_statistics(description, is_resumed ? std::optional(begun) : std::nullopt);
  if (options.json && last_said < 0) fmt::print("{}", statistics_header(StatisticsFormat::json_lines, description));
  if (!options.shapes.empty()) {
    exported.frames.first = std::max(range.first, is_resumed ? start_frame(run.scene) : begun);
    exported.last_kept = is_resumed ? std::optional(begun) : std::nullopt;
    run.shapes = open_sink(exported, run.loaded, run.simulation->state().current);
  }
  run.outputs.start_frame = begun;
  run.outputs.with_start = !is_resumed && range.first <= begun;
  const bool is_read = !options.quiet || options.json || run.statistics || !options.checkpoint_file().empty();
  run.outputs.measured = is_read ? Measured::all : Measured::promises;
  run.outputs.report = [&](const FrameRecord& record) { running.report(record); };
  try {
    run.go(range.last, options.shapes, nullptr);
  } catch (const Interrupted&) {
    if (options.checkpoint_file().empty()) throw;
    return running.stop();
  }
  return running.finish();
}

}  // namespace

int run(const SimulateOptions& options) {
  int last_said = -1;
  return run_showing_what_fits(
      [&](const std::string& why_not_model) { return simulate(options, why_not_model, last_said); });
}

}  // namespace taut::app
