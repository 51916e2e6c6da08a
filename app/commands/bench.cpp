#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/interruption.hpp"
#include "app/base/progress.hpp"
#include "app/base/suggest.hpp"
#include "app/base/version.hpp"
#include "app/bench/bench_output.hpp"
#include "app/commands/options.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/obj_writing.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

// Defaults of the measurement.
struct Extent {
  std::vector<int> sizes;
  std::vector<std::string> scenes;
  double seconds;
  double slowest_frame_ms;
};

const Extent quick_extent = {{1028, 10600}, {"hanging"}, 2.0, 250.0};
const Extent full_extent = {{1028, 5280, 10600, 42400, 84480}, {"hanging", "shaken", "wind"}, 10.0, 500.0};

void require_bench_scenes(const std::vector<std::string>& scenes) {
  const std::vector<std::string> all = bench_scene_names();
  for (const std::string& name : scenes) {
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw UsageError("--scenes: found '" + name + '\'' + did_you_mean(name, all) + "; expected some of " +
                       joined(all, ",") + ", or with --contact one of its scenes");
    }
  }
}

BenchOptions completed(BenchOptions options) {
  const Extent& extent = options.full ? full_extent : quick_extent;
  if (options.sizes.empty()) {
    options.sizes = options.ablation ? std::vector<int>{10600} : extent.sizes;
  }
  if (options.scenes.empty()) {
    options.scenes = extent.scenes;
  }
  if (options.engines.empty()) {
    options.engines = engine_names();
  }
  options.seconds = options.seconds.value_or(extent.seconds);
  options.slowest_frame_ms = options.slowest_frame_ms.value_or(extent.slowest_frame_ms);
  std::sort(options.bounds.rbegin(), options.bounds.rend());
  return options;
}

std::vector<Entrant> entrants_for(const BenchOptions& options) {
  if (options.ablation) {
    return ablation_entrants(options.bounds);
  }
  std::vector<Entrant> entrants;
  for (const std::string& engine : options.engines) {
    const std::vector<Entrant> some = entrants_of(engine, options.bounds, options.full);
    entrants.insert(entrants.end(), some.begin(), some.end());
  }
  if (entrants.empty()) {
    throw InputError("this program was built without Bullet; --engines names no other");
  }
  return entrants;
}

// The numbers are those of the runs in the JSON.
void write_shapes(const std::filesystem::path& folder, const Heat& heat, const sim::Mesh& mesh) {
  for (std::size_t i = 0; i < heat.runs.size(); ++i) {
    if (!heat.runs[i].frames.empty()) {
      write_text_file(folder / fmt::format("{}_{}_{}.obj", heat.scene.name, heat.size.triangles, i),
                      obj_text(mesh, heat.runs[i].most_stretched));
    }
  }
}

Heat run_heat(const BenchScene& bench_scene, const BenchSize& size, const BenchOptions& options,
              const std::vector<Entrant>& entrants, const std::function<void(const std::string&)>& show) {
  const Scene scene = make_bench_scene(bench_scene, size);
  const LoadedGarment loaded = load_garment(scene);
  const sim::Garment& garment = *loaded.garment;
  Heat heat{bench_scene,
            size,
            garment.springs.structural_count,
            garment.springs.count(sim::SpringKind::flexural),
            {},
            measure_sweep_speeds(garment)};
  RaceSettings settings;
  settings.frames =
      std::max(1, static_cast<int>(std::lround(*options.seconds * scene.simulation.frame_rate_hz)));
  settings.slowest_frame_ms = *options.slowest_frame_ms;
  heat.runs = race(entrants, loaded, scene, settings, [&](int frame) {
    throw_if_interrupted();
    show(fmt::format("{}, {} triangles, {} settings in turns: frame {} of {}", bench_scene.name,
                     size.triangles, entrants.size(), frame, settings.frames));
  });
  if (!options.shapes.empty()) {
    write_shapes(options.shapes, heat, garment.mesh);
  }
  return heat;
}

BenchResults run_all(const BenchOptions& options) {
  std::optional<Progress> progress;
  if (!options.quiet) {
    progress.emplace("bench");
  }
  const auto show = [&](const std::string& stage) { progress ? progress->show(stage) : void(); };
  const std::vector<Entrant> entrants = entrants_for(options);
  BenchResults results;
  results.bounds = options.bounds;
  results.is_ablation = options.ablation;
  for (const BenchScene& scene : bench_scenes()) {
    for (const BenchSize& size : bench_sizes()) {
      const auto is_wanted = [](const auto& list, const auto& item) {
        return std::find(list.begin(), list.end(), item) != list.end();
      };
      if (is_wanted(options.scenes, scene.name) && is_wanted(options.sizes, size.triangles)) {
        results.heats.push_back(run_heat(scene, size, options, entrants, show));
      }
    }
  }
  results.frames = static_cast<int>(std::lround(*options.seconds * results.frame_rate_hz));
  return results;
}

void write_results(const BenchOptions& options, const BenchResults& results, const std::string& json) {
  const auto tell = [&](const std::filesystem::path& path) {
    if (!options.quiet && !options.json) {
      fmt::print("wrote {}\n", path.string());
    }
  };
  write_text_file(options.output / "bench.json", json);
  tell(options.output / "bench.json");
  const Drawing drawing = draw_bench(results);
  const std::vector<renderer::PngText> texts = {{"Software", "taut " + program_version()}};
  write_file(options.output / "bench.png", renderer::encode_png(to_image(drawing), texts));
  tell(options.output / "bench.png");
  write_pdf(options.output / "bench.pdf", drawing, "taut bench: time for one frame against stretch");
  tell(options.output / "bench.pdf");
}

}  // namespace

int run(const BenchOptions& given) {
  if (given.contact) {
    return run_contact_bench(given);
  }
  require_bench_scenes(given.scenes);
  const BenchOptions options = completed(given);
  if (!options.output.empty()) {
    prepare_folder_of(options.output / "bench.json");
  }
  if (!options.shapes.empty()) {
    prepare_folder_of(options.shapes / "shape.obj");
  }
  const Machine machine = this_machine("");
  const BenchResults results = run_all(options);
  const std::string json = bench_json(results, machine);
  if (options.json) {
    fmt::print("{}", json);
  } else if (!options.quiet) {
    fmt::print("{}", bench_table(results));
  }
  if (!options.output.empty()) {
    write_results(options, results, json);
  }
  return 0;
}

}  // namespace taut::app
