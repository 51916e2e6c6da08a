#include <fmt/core.h>

#include <algorithm>
#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/job_runner.hpp"
#include "app/commands/options.hpp"
#include "app/figures/fabric_pictures.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

std::vector<DrapedFabric> drape_all(const std::vector<std::string>& names) {
  std::vector<DrapedFabric> fabrics;
  for (const std::string& name : names) {
    const DrawnScene scene = made_of({}, name);
    fabrics.push_back({find_fabric(name), scene, std::vector<DrapeRun>(drape_meshes.size())});
  }
  std::vector<Job> jobs;
  for (DrapedFabric& fabric : fabrics) {
    for (std::size_t k = 0; k < drape_meshes.size(); ++k) {
      const auto hang = [&fabric, k](const ProgressCallback& report) {
        fabric.runs[k] = run_drape(fabric.scene.material, drape_meshes[k], report);
      };
      jobs.push_back({fabric.fabric.name, 1.0 / drape_meshes[k].edge_m, hang});
    }
  }
  run_jobs(jobs, std::max(1U, std::thread::hardware_concurrency()), [](std::size_t) {});
  return fabrics;
}

/// "within", "above" or "below" what is published.
std::string verdict(const DrapedFabric& draped) {
  const auto& band = draped.fabric.published_drape_percent;
  if (!band) {
    return "";
  }
  const double percent = draped.mean_percent();
  return percent < (*band)[0] ? "below" : percent > (*band)[1] ? "above" : "within";
}

void print_table(const std::vector<DrapedFabric>& fabrics) {
  fmt::print("{:<10} {:>7} {:>6} {:>7} {:>10}\n", "", "drape %", "+-", "folds", "published");
  for (const DrapedFabric& draped : fabrics) {
    fmt::print("{:<10} {:>7.1f} {:>6.1f} {:>7} {:>10}  {}\n", draped.fabric.name, draped.mean_percent(),
               draped.spread_percent(), draped.folds(), draped.fabric.published_drape_text(),
               verdict(draped));
  }
}

Json fabric_json(const DrapedFabric& draped) {
  Json runs = Json::array();
  for (std::size_t k = 0; k < draped.runs.size(); ++k) {
    const DrapeRun& run = draped.runs[k];
    runs.push_back({{"edge_m", drape_meshes[k].edge_m},
                    {"seed", drape_meshes[k].seed},
                    {"triangles", run.garment->mesh.triangles.size()},
                    {"drape_percent", 100.0 * run.shadow.coefficient},
                    {"folds", run.shadow.folds},
                    {"frames", run.frames},
                    {"at_rest", run.at_rest},
                    {"max_surface_stretch", run.max_stretch}});
  }
  const auto& band = draped.fabric.published_drape_percent;
  return {{"fabric", draped.fabric.name},
          {"drape_percent", draped.mean_percent()},
          {"spread_percent", draped.spread_percent()},
          {"published_percent", band ? Json(*band) : Json()},
          {"runs", runs}};
}

}  // namespace

int run(const DrapeOptions& options) {
  if (options.output.extension() != ".png") {
    throw UsageError("--output " + options.output.string() + ": expected a name that ends in .png");
  }
  prepare_folder_of(options.output);
  const std::vector<DrapedFabric> fabrics =
      drape_all(options.fabrics.empty() ? built_in_fabrics() : options.fabrics);
  if (fabrics.empty()) {
    throw InputError("no fabrics were found; set TAUT_ASSETS to the folder that holds fabrics/");
  }
  LazyOffscreenRenderer offscreen(options.backend, 1.0F);
  write_file(options.output, renderer::encode_png(to_image(draw_drapes(fabrics, offscreen))));
  if (options.json) {
    Json all = Json::array();
    std::transform(fabrics.begin(), fabrics.end(), std::back_inserter(all), fabric_json);
    fmt::print("{}\n", Json({{"picture", options.output.string()}, {"fabrics", all}}).dump(2));
  } else {
    print_table(fabrics);
    fmt::print("wrote {}\n", options.output.string());
  }
  return 0;
}

}  // namespace taut::app
