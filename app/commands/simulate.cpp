#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/base/stopwatch.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/commands/blocked_run.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/models/model_fitting.hpp"
#include "app/output/frame_record.hpp"
#include "app/output/output_pattern.hpp"
#include "app/output/frame_verifier.hpp"
#include "app/output/run_checkpoint.hpp"
#include "app/output/run_start.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {
namespace {

/// A line for every frame in the range; of frames in which the cloth sleeps one that says so.
class FrameLines {
 public:
  explicit FrameLines(FrameRange range) : range_(range) {}

  void print(const FrameRecord& record) {
    const bool is_said = record.asleep && sleep_is_said_;
    if (!range_.contains(record.frame) || is_said) {
      return;
    }
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
      "{}, {:.2f} ms of processor time each; largest stretch {:.4f} % (frame {}), at the end {:.4f} %; "
      "of the surface {:.4f} % (frame {}), at the end {:.4f} %{}{}\n",
      counted(summary.frames, "frame"), summary.mean_sim_ms(), 100.0 * summary.max_stretch,
      summary.max_stretch_frame, 100.0 * summary.final_max_stretch, 100.0 * summary.max_surface_stretch,
      summary.max_surface_stretch_frame, 100.0 * summary.final_max_surface_stretch,
      summary.asleep_since_frame < 0 ? ""
                                     : fmt::format("; at rest since frame {}", summary.asleep_since_frame),
      describe_crossings(summary).empty() ? "" : "; " + describe_crossings(summary));
}

bool is_told(const SimulateOptions& options) {
  return !options.quiet && !options.json;
}

/// The scene's garment, with the hanger that it asks for, with what was guessed and repaired said on
/// `remarks`, where there is one.
LoadedGarment load(DrawnScene& scene, Progress& progress, std::FILE* remarks) {
  LoadedGarment loaded = load_garment(scene, [&](const std::string& stage) { progress.begin(stage); });
  progress.hide();
  print_body_remarks(scene, put_where_it_begins(loaded, scene), remarks);
  if (remarks != nullptr) {
    print_remarks(scene, loaded, remarks);
  }
  progress.begin("frame 1");
  return loaded;
}

/// Crossing pairs in the checkpoint that a scene begins with. Of other starts it was said as a remark.
void say_start(const SimulateOptions& options, const DrawnScene& scene, const std::string& crossings) {
  if (is_told(options) && !scene.checkpoint.empty() && !crossings.empty()) {
    fmt::print("{}: at the start {}\n", scene.name, crossings);
  }
}

/// The run as it begins or goes on; puts the simulation there.
RunCheckpoint begin(const SimulateOptions& options, const DrawnScene& scene, FrameVerifier& verifier,
                    sim::Simulation& simulation) {
  RunCheckpoint run;
  if (!options.resume.empty()) {
    if (options.verify) {
      verifier.begin(simulation);  // where the run began, which is not where it goes on
    }
    run = read_run_checkpoint(options.resume);
    require_same_scene(options.resume, run, scene.name, scene_text(scene));
    restore(options.resume, run, simulation);
  } else {
    run.scene_name = scene.name;
    run.scene = scene_text(scene);
    run.frame = go_to_start(scene, simulation);
    if (options.verify) {
      say_start(options, scene, verifier.begin(simulation));
    }
  }
  return run;
}

/// The statistics of the run, new or gone on with.
std::optional<StatisticsFile> statistics_of(const SimulateOptions& options, const RunDescription& description,
                                            const RunCheckpoint& run) {
  if (options.statistics.empty()) {
    return std::nullopt;
  }
  const bool goes_on = !options.resume.empty() && run.summary.frames > 0;
  return StatisticsFile(options.statistics, description, goes_on ? std::optional(run.frame) : std::nullopt);
}

// The end of a run: said, printed for programs, written.
void hand_over(const SimulateOptions& options, const RunSummary& summary,
               const std::unique_ptr<FrameSink>& shapes, std::optional<StatisticsFile>& statistics) {
  const std::string written = shapes ? shapes->finish() + '\n' : "";
  if (is_told(options)) {
    print_summary(summary);
    fmt::print("{}", written);
  }
  if (options.json) {
    fmt::print("{}", statistics_end(StatisticsFormat::json_lines, summary));
  }
  if (statistics) {
    statistics->finish(summary);
    fmt::print("{}", is_told(options) ? "wrote " + options.statistics.string() + '\n' : "");
  }
}

void try_outputs(const SimulateOptions& options) {
  for (const std::filesystem::path& file : {options.statistics, options.saved_to()}) {
    if (!file.empty()) {
      prepare_folder_of(file);
    }
  }
}

/// Where shapes go, once it is known where the run begins; none if nobody asks for them.
std::unique_ptr<FrameSink> shapes_of(const SimulateOptions& options, ExportSettings settings,
                                     const DrawnScene& scene, const GarmentInScene& loaded,
                                     const sim::Simulation& simulation, int begun) {
  if (options.shapes.empty()) {
    return nullptr;
  }
  const bool goes_on = !options.resume.empty();
  settings.frames.first = std::max(settings.frames.first, goes_on ? start_frame(scene) : begun);
  settings.last_kept = goes_on ? std::optional(begun) : std::nullopt;
  return open_sink(settings, loaded, simulation);
}

/// A run under way.
struct Running {
  const SimulateOptions& options;
  const sim::Simulation& simulation;
  Progress& progress;
  FrameLines lines;
  RunCheckpoint run;
  std::optional<StatisticsFile> statistics;
  std::unique_ptr<FrameSink> shapes;
  int first_frame = 0;
  int last_frame = 0;
  Stopwatch since_start = {};

  /// Counts, files and messages of a frame, as it comes.
  void report(const FrameRecord& record) {
    run.frame = record.frame;
    run.summary.add(record);
    if (statistics) {
      statistics->add(record);
    }
    if (options.json) {
      fmt::print("{}", statistics_line(StatisticsFormat::json_lines, record));
    }
    if (is_told(options)) {
      progress.hide();
      lines.print(record);
    }
    if (record.frame % options.checkpoint_every == 0) {
      save();
    }
    progress.begin(fmt::format(
        "frame {} of {}{}", record.frame + 1, last_frame,
        time_left(1e-3 * since_start.elapsed_ms(), record.frame - first_frame, last_frame - first_frame)));
  }

  void save() {
    if (!options.saved_to().empty()) {
      if (shapes) {
        shapes->keep();
      }
      run.simulation = sim::encode(simulation.save(), simulation.garment());
      write_run_checkpoint(options.saved_to(), run);
    }
  }

  /// Of a run that ends early: completes the shapes before.
  void finish_shapes() {
    progress.hide();
    const std::string written = shapes ? shapes->finish() + '\n' : "";
    fmt::print("{}", is_told(options) ? written : "");
  }

  /// Saves the run and says how it goes on. Returns the exit code.
  int stop() {
    save();
    progress.hide();
    std::fflush(stdout);
    fmt::print(stderr,
               "taut: stopped after frame {0}, saved in '{1}': the same command with --resume {1} goes on\n",
               run.frame, options.saved_to().string());
    return exit_can_be_resumed;
  }
};

}  // namespace

int run(const SimulateOptions& options) {
  DrawnScene scene = find_scene(options.scene, options.overrides);
  std::FILE* const remarks = options.quiet ? nullptr : options.json ? stderr : stdout;
  print_body_remarks(scene, load_bodies(scene), remarks);
  const FrameRange range =
      options.frames.empty() ? FrameRange{1, scene.frames}
                             : frame_range(options.frames, scene.frames,
                                           is_clip(options.shapes) ? NumberMeans::count : NumberMeans::frame);
  const ExportSettings exported = {options.shapes, range, scene.simulation.frame_rate_hz,
                                   !options.saved_to().empty()};
  FrameOutputs outputs;
  if (!options.shapes.empty()) {
    require_export(exported, scene.garment.file);
  }
  statistics_format(options.statistics);
  try_outputs(options);

  Progress progress(scene.name);
  const LoadedGarment loaded = load(scene, progress, remarks);
  sim::Simulation simulation = make_simulation(scene, loaded);
  FrameVerifier verifier;
  RunCheckpoint begun = begin(options, scene, verifier, simulation);
  require_begun(begun.frame, range.last);
  outputs.start_frame = begun.frame;
  outputs.with_start = options.resume.empty() && range.first <= begun.frame;
  const RunDescription description = {scene, simulation.garment(), simulation.pins().vertices.size(), "",
                                      options.verify};
  std::optional<StatisticsFile> statistics = statistics_of(options, description, begun);
  if (options.json) {
    fmt::print("{}", statistics_header(StatisticsFormat::json_lines, description));
  }
  Running running{options,
                  simulation,
                  progress,
                  FrameLines(range),
                  {},
                  std::move(statistics),
                  shapes_of(options, exported, scene, loaded, simulation, begun.frame)};
  running.first_frame = begun.frame;
  running.last_frame = range.last;
  running.run = std::move(begun);
  if (running.shapes) {
    outputs.write_shape = [&](int frame, const auto& moment) { running.shapes->write(frame, moment); };
  }
  const bool is_read = !options.quiet || options.json || running.statistics || !options.saved_to().empty();
  outputs.measured = is_read ? Measured::all : Measured::promises;
  outputs.report = [&](const FrameRecord& record) { running.report(record); };
  if (options.verify) {
    outputs.verify = [&](const auto& moment, FrameRecord& record) { return verifier.check(moment, record); };
  }
  try {
    run_frames(simulation, range.last, outputs);
  } catch (const Interrupted&) {
    if (options.saved_to().empty()) {
      throw;
    }
    return running.stop();
  } catch (const FrameBlocked& error) {
    running.finish_shapes();
    end_blocked(error, scene, simulation, options.shapes);
  } catch (const PromiseBroken&) {
    running.finish_shapes();
    throw;
  } catch (const sim::Diverged&) {
    running.finish_shapes();
    throw;
  }
  progress.hide();
  running.save();
  hand_over(options, running.run.summary, running.shapes, running.statistics);
  if (is_told(options)) {
    const std::string following = describe_following(loaded, simulation.state().current);
    fmt::print("{}{}", following.empty() ? "" : following + '\n', options.verify ? verifier.summary() + '\n' : "");
  }
  return judge_bound(scene, running.run.summary);
}

}  // namespace taut::app
