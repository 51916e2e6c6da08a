// drape_meter [FABRIC or FILE...]: compares the drape of fabrics over a disc with published ranges. Writes drape.png
// and prints a table.
#include <fmt/core.h>

#include <algorithm>
#include <thread>

#include "app/base/files.hpp"
#include "app/base/job_runner.hpp"
#include "drape_meter.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

std::vector<DrapedFabric> drape_all(const std::vector<std::string>& names) {
  std::vector<DrapedFabric> fabrics;
  for (const std::string& name : names) {
    const DrawnScene scene = set_fabric({}, name);
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

/// Returns "within", "above" or "below" for the published range.
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

}  // namespace

}  // namespace taut::app

int main(int count, char** words) {
  using namespace taut::app;
  const std::vector<std::string> names(words + 1, words + count);
  const std::vector<DrapedFabric> fabrics = drape_all(names.empty() ? built_in_fabrics() : names);
  LazyOffscreenRenderer offscreen("auto", 1.0F);
  write_file("drape.png", taut::renderer::encode_png(to_image(draw_drapes(fabrics, offscreen))));
  print_table(fabrics);
}
