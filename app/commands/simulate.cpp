#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "app/base/counted.hpp"
#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/output/bound_verdict.hpp"
#include "app/output/frame_range.hpp"
#include "app/output/obj_export.hpp"
#include "app/output/output_pattern.hpp"
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
    fmt::print("frame {:5}  time {:8.4f} s  max stretch {:8.4f} %  p99 {:8.4f} %  rms speed {:9.6f} m/s{}\n",
               record.frame, record.time_s, 100.0 * record.stretch.max, 100.0 * record.stretch.p99,
               record.rms_speed_m_per_s, record.asleep ? "  asleep, no more lines until it wakes" : "");
    // Whoever reads it through a pipe sees it now and not when the run is over.
    std::fflush(stdout);
  }

 private:
  FrameRange range_;
  bool sleep_is_said_ = false;
};

void print_summary(const RunSummary& summary) {
  fmt::print(
      "{}, {:.2f} ms of processor time each; largest stretch {:.4f} % (frame {}), at the end {:.4f} %{}\n",
      counted(summary.frames, "frame"), summary.mean_sim_ms, 100.0 * summary.max_stretch,
      summary.max_stretch_frame, 100.0 * summary.final_max_stretch,
      summary.asleep_since_frame < 0 ? ""
                                     : fmt::format("; at rest since frame {}", summary.asleep_since_frame));
}

bool is_told(const SimulateOptions& options) {
  return !options.quiet && !options.json;
}

/// Where shapes go: a file for every frame in the range, or one for the last of them.
class ShapeOutput {
 public:
  ShapeOutput(const std::string& pattern, FrameRange range) : pattern_(pattern, ".obj"), range_(range) {
    range_.first = pattern_.has_field() ? range.first : range.last;
    prepare_folder_of(pattern_.path_of(range_.first));
  }

  void write(int frame, const sim::Simulation& moment) const {
    if (range_.contains(frame)) {
      write_text_file(pattern_.path_of(frame), obj_text(moment.garment().mesh, moment.state().current));
    }
  }

  std::string describe() const {
    std::vector<int> frames(static_cast<std::size_t>(range_.count()));
    std::iota(frames.begin(), frames.end(), range_.first);
    return describe_written(pattern_, frames);
  }

 private:
  OutputPattern pattern_;
  FrameRange range_;
};

/// The simulation of the scene's garment, with what was guessed and repaired said on `remarks`, where there
/// is one.
sim::Simulation prepare(const DrawnScene& scene, Progress& progress, std::FILE* remarks) {
  const LoadedGarment loaded = load_garment(scene, [&](const std::string& stage) { progress.begin(stage); });
  progress.hide();
  if (remarks != nullptr) {
    print_remarks(scene, loaded, remarks);
  }
  progress.begin("frame 1");
  return make_simulation(scene, loaded);
}

// What a run ends with: said, printed for programs, written.
void hand_over(const SimulateOptions& options, const RunStatistics& statistics, const RunSummary& summary,
               const std::optional<ShapeOutput>& shapes) {
  if (is_told(options)) {
    print_summary(summary);
    fmt::print("{}", shapes ? shapes->describe() + '\n' : "");
  }
  if (options.json) {
    fmt::print("{}", statistics_json(statistics));
  }
  if (!options.statistics.empty()) {
    write_statistics(options.statistics, statistics);
    fmt::print("{}", is_told(options) ? "wrote " + options.statistics.string() + '\n' : "");
  }
}

}  // namespace

int run(const SimulateOptions& options) {
  const DrawnScene scene = find_scene(options.scene, options.overrides);
  const FrameRange range =
      options.frames.empty() ? FrameRange{1, scene.frames} : frame_range(options.frames, scene.frames);
  std::optional<ShapeOutput> shapes;
  FrameOutputs outputs;
  outputs.with_frame_0 = range.first == 0;
  if (!options.shapes.empty()) {
    shapes.emplace(options.shapes, range);
    outputs.write_shape = [&](int frame, const sim::Simulation& moment) { shapes->write(frame, moment); };
  }
  prepare_statistics(options.statistics);

  Progress progress(scene.name);
  sim::Simulation simulation = prepare(scene, progress,
                                       options.quiet  ? nullptr
                                       : options.json ? stderr
                                                      : stdout);
  FrameLines lines(range);
  outputs.report = [&](const FrameRecord& record) {
    if (is_told(options)) {
      progress.hide();
      lines.print(record);
    }
    progress.begin(fmt::format("frame {}", record.frame + 1));
  };
  const std::vector<FrameRecord> records = run_frames(simulation, range.last, outputs);
  progress.hide();

  const RunSummary summary = summarise(records);
  hand_over(options, {scene, simulation.garment(), simulation.pins().vertices.size(), "", records}, summary,
            shapes);
  return judge_bound(scene, summary);
}

}  // namespace taut::app
