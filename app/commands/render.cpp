#include <fmt/core.h>

#include <numeric>

#include "app/commands/options.hpp"
#include "app/files.hpp"
#include "app/frame_loop.hpp"
#include "app/garment_loading.hpp"
#include "app/garment_painter.hpp"
#include "app/output_pattern.hpp"
#include "app/progress.hpp"
#include "app/run_report.hpp"
#include "app/scene_lookup.hpp"
#include "app/studio.hpp"
#include "app/version.hpp"

namespace taut::app {
namespace {

std::vector<int> frames_to_draw(const RenderOptions& options, const Scene& scene) {
  const FrameRange range = options.frames.value_or(FrameRange{scene.frames, scene.frames});
  std::vector<int> frames(static_cast<std::size_t>(range.last - range.first) + 1);
  std::iota(frames.begin(), frames.end(), range.first);
  return frames;
}

}  // namespace

int run(const RenderOptions& options) {
  const Scene scene = find_scene(options.scene, options.overrides);
  const std::vector<int> frames = frames_to_draw(options, scene);
  const OutputPattern pattern(options.output.empty() ? scene.name + ".png" : options.output, ".png");
  pattern.require_distinct_names(frames.size());
  prepare_folder_of(pattern.path_of(frames.front()));
  if (!options.statistics.empty()) {
    prepare_folder_of(options.statistics);
  }

  sim::Simulation simulation(load_garment(scene).garment, scene.simulation, scene.surroundings);
  Studio studio(options.backend);
  GarmentPainter painter(studio.renderer(), scene, simulation.garment());
  const std::vector<renderer::PngText> texts = {{"Software", "taut " + program_version()}};

  FrameOutputs outputs;
  outputs.pictures = frames;
  outputs.draw_picture = [&](const sim::Simulation& moment) { return painter.draw(moment.state().current); };
  outputs.write_picture = [&](int frame, const renderer::Image& picture) {
    renderer::write_png(pattern.path_of(frame), picture, texts);
  };
  std::vector<FrameRecord> records;
  {
    Progress progress(scene.name, frames.back());
    outputs.report = [&](const FrameRecord& record) { progress.show(record.frame, record.stretch.max); };
    records = run_frames(simulation, frames.back(), outputs);
  }

  if (!options.statistics.empty()) {
    write_text_file(options.statistics,
                    statistics_json(scene, simulation.garment(), studio.gl_renderer(), records));
    fmt::print("wrote {}\n", options.statistics.string());
  }
  fmt::print("{}\n", describe_written(pattern, frames));
  return 0;
}

}  // namespace taut::app
