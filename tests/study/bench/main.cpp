#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/scene/scene_format.hpp"
#include "race.hpp"

namespace taut::app {
namespace {

struct RaceOptions {
  std::vector<int> sizes = {1028, 10600};
  std::vector<std::string> scenes = {"hanging"};
  std::vector<double> bounds = {0.05, 0.01, 0.001};
  double seconds = 2.0;
  double max_frame_ms = 250.0;
};

// Settings of each scene, as the shirt hangs by its neckline.
const std::map<std::string, std::vector<std::string>> scene_settings = {
    {"hanging", {}},
    {"shaken", {"pins.motion.amplitude=[0.1, 0.0, 0.0]", "pins.motion.frequency=1.0"}},
    {"wind", {"wind.speed=10.0", "wind.direction=[0.3, 0.0, 1.0]"}}};

// Returns the shirt without contact, which Bullet has not for this. Each subdivision of a model has four times as many
// triangles.
Scene make_race_scene(const std::string& name, int triangles) {
  int model = triangles, subdivisions = 0;
  for (; model > 10600; model /= 4) ++subdivisions;
  std::vector<std::string> settings = scene_settings.at(name);
  settings.insert(settings.end(),
                  {fmt::format("garment.file=tshirt_{}", model), fmt::format("garment.subdivisions={}", subdivisions),
                   R"(pins.at=["front_neckline", "back_neckline"])", "solver.contact=false"});
  std::vector<Override> overrides;
  std::ranges::transform(settings, std::back_inserter(overrides), parse_override);
  return find_scene(undrawn_format(), "tshirt-gravity", overrides);
}

void print_best(std::span<const Run> runs, const std::vector<double>& bounds) {
  fmt::print(
      "   bound  engine                            median     mean    worst  surface\n"
      "                                              ms of a frame   edge, %        %\n");
  for (const double bound : bounds) {
    std::set<std::string> engines;
    for (const Run& run : runs) {
      const Run* best = best_run(runs, run.entrant.engine, bound);
      if (best == nullptr || !engines.insert(run.entrant.engine).second) continue;
      std::vector<double> times_ms;
      double surface_stretch = 0.0, sum_ms = 0.0;
      for (const RaceFrame& frame : best->frames) {
        times_ms.push_back(frame.cpu_ms);
        sum_ms += frame.cpu_ms;
        surface_stretch = std::max(surface_stretch, frame.surface_stretch);
      }
      fmt::print("{:6g} %  {:<31}{:9.2f}{:9.2f}{:9.3f}{:9.3f}  {}{}\n", 100.0 * bound, best->entrant.engine,
                 quantile(times_ms, 0.5), sum_ms / static_cast<double>(times_ms.size()), 100.0 * best->max_stretch(),
                 100.0 * surface_stretch, best->entrant.settings, best->given_up.empty() ? "" : ", " + best->given_up);
    }
  }
}

void run_all(const RaceOptions& options) {
  fmt::print(
      "For each bound the fastest setting whose worst edge keeps it in every frame, else the one that comes "
      "closest; substeps x iterations.\n");
  std::vector<Entrant> entrants = taut_entrants(options.bounds);
  std::ranges::move(bullet_entrants(), std::back_inserter(entrants));
  for (const std::string& name : options.scenes) {
    for (const int triangles : options.sizes) {
      const Scene scene = make_race_scene(name, triangles);
      const int frames = std::max(1, static_cast<int>(std::lround(options.seconds * scene.simulation.frame_rate_hz)));
      fmt::print("\n{}, {} triangles, {} frames\n", name, triangles, frames);
      print_best(race(entrants, load_garment(scene), scene, frames, options.max_frame_ms), options.bounds);
    }
  }
}

}  // namespace
}  // namespace taut::app

int main(int count, char** words) {
  taut::app::RaceOptions options;
  CLI::App app("Time for a frame against stretch, side by side with Bullet");
  app.add_option("--sizes", options.sizes, "triangles: some of 1028,5280,10600,42400,84480")->delimiter(',');
  app.add_option("--scenes", options.scenes, "some of hanging,shaken,wind")
      ->delimiter(',')
      ->check(CLI::IsMember(taut::app::scene_settings));
  app.add_option("--bounds", options.bounds, "largest stretches to be kept")->delimiter(',');
  app.add_option("--seconds", options.seconds, "simulated time");
  app.add_option("--limit", options.max_frame_ms, "ms per frame above which a setting is given up");
  CLI11_PARSE(app, count, words);
  taut::app::run_all(options);
}
