#include <fmt/core.h>

#include <cstdio>
#include <numeric>

#include "app/commands/options.hpp"
#include "app/frame_loop.hpp"
#include "app/garment/garment_loading.hpp"
#include "app/garment/garment_remarks.hpp"
#include "app/garment/layers.hpp"
#include "app/garment/obj_export.hpp"
#include "app/output/bound_verdict.hpp"
#include "app/output/files.hpp"
#include "app/output/output_pattern.hpp"
#include "app/output/progress.hpp"
#include "app/output/run_report.hpp"
#include "app/scene/scene_lookup.hpp"

namespace taut::app {
namespace {

void print_record(const FrameRecord& record) {
  fmt::print("frame {:5}  time {:8.4f} s  max stretch {:8.4f} %  p99 {:8.4f} %  rms speed {:9.6f} m/s{}\n",
             record.frame, record.time_s, 100.0 * record.stretch.max, 100.0 * record.stretch.p99,
             record.rms_speed_m_per_s, record.asleep ? "  asleep" : "");
}

void print_summary(const RunSummary& summary) {
  fmt::print("{} frames, {:.2f} ms each; largest stretch {:.4f} % (frame {}), at the end {:.4f} %{}\n",
             summary.frames, summary.mean_sim_ms, 100.0 * summary.max_stretch, summary.max_stretch_frame,
             100.0 * summary.final_max_stretch,
             summary.asleep_since_frame < 0
                 ? ""
                 : fmt::format("; at rest since frame {}", summary.asleep_since_frame));
}

}  // namespace

int run(const SimulateOptions& options) {
  const Scene scene = find_scene(options.scene, options.overrides);
  const int frame_count = options.frames.value_or(scene.frames);
  FrameOutputs outputs;
  std::optional<OutputPattern> shapes;
  if (!options.shapes.empty()) {
    shapes.emplace(options.shapes, ".obj");
    shapes->require_distinct_names(static_cast<std::size_t>(frame_count));
    prepare_folder_of(shapes->path_of(1));
    outputs.write_shape = [&](int frame, const sim::Simulation& moment) {
      write_text_file(shapes->path_of(frame), obj_text(moment.garment().mesh, moment.state().current));
    };
  }
  if (!options.statistics.empty()) {
    prepare_folder_of(options.statistics);
  }

  Progress progress(scene.name);
  LoadedGarment loaded = load_garment(scene, [&](const std::string& stage) { progress.begin(stage); });
  progress.hide();
  print_remarks(scene, loaded);
  progress.begin("frame 1");
  sim::Simulation simulation = make_simulation(scene, std::move(loaded));
  outputs.report = [&](const FrameRecord& record) {
    progress.hide();
    print_record(record);
    progress.begin(fmt::format("frame {}", record.frame + 1));
  };
  const std::vector<FrameRecord> records = run_frames(simulation, frame_count, outputs);
  progress.hide();

  const RunSummary summary = summarise(records);
  print_summary(summary);
  if (shapes) {
    std::vector<int> frames(static_cast<std::size_t>(frame_count));
    std::iota(frames.begin(), frames.end(), 1);
    fmt::print("{}\n", describe_written(*shapes, frames));
  }
  if (!options.statistics.empty()) {
    write_text_file(options.statistics, statistics_json(scene, simulation.garment(), "", records));
    fmt::print("wrote {}\n", options.statistics.string());
  }
  return judge_bound(scene, summary);
}

}  // namespace taut::app
