// Time against stretch: Taut's solvers, their parts and Bullet on one T-shirt.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/base/files.hpp"
#include "app/runs/csv.hpp"
#include "race.hpp"

namespace taut::app {
namespace {

struct Options {
  std::vector<int> sizes = {1028, 10600};
  std::vector<std::string> scenes = {"hanging"};
  std::vector<std::string> engines = engine_names();
  std::vector<double> bounds = {0.05, 0.01, 0.001};
  double seconds = 2.0;
  double slowest_frame_ms = 250.0;
  bool full = false;
  bool ablation = false;
  std::string csv;
};

std::vector<Entrant> entrants_for(const Options& options) {
  std::vector<Entrant> entrants;
  for (const std::string& engine : options.engines) {
    const auto some = list_entrants(engine, options.bounds, options.full);
    entrants.insert(entrants.end(), some.begin(), some.end());
  }
  return options.ablation ? ablation_entrants(options.bounds) : entrants;
}

void print_row(const Run& run, double bound) {
  const RunFacts facts = summarise_run(run);
  fmt::print("{:6g} %  {:<12}{:9.2f}{:9.2f}{:9.2f}{:9.3f}{:9.3f}{:9.3f}{:9.3f}{:8}{:8}  {}{}\n", 100.0 * bound,
             run.entrant.engine, facts.median_ms, facts.mean_ms, facts.p99_ms, 100.0 * facts.stretch,
             100.0 * facts.p99_stretch, 100.0 * facts.surface_stretch, 100.0 * facts.p99_surface_stretch,
             frames_over(run, bound), facts.not_certified, run.entrant.settings,
             run.end == RunEnd::finished ? "" : fmt::format(", {}", to_name(run.end)));
}

void print_heat(const std::vector<Run>& runs, const Options& options) {
  fmt::print(
      "   bound  engine         median     mean     99 %    worst     99 %  surface    99 %  frames     not\n"
      "                             ms of a frame     edge, %  edges, %       %        %    over  certif.\n");
  for (const double bound : options.bounds) {
    std::vector<std::string> engines;
    for (const Run& run : runs) {
      if (std::find(engines.begin(), engines.end(), run.entrant.engine) == engines.end()) {
        engines.push_back(run.entrant.engine);
        if (const Run* best = best_run(runs, run.entrant.engine, bound)) {
          print_row(*best, bound);
        }
      }
    }
  }
}

void add_rows(const RaceScene& scene, const RaceSize& size, const std::vector<Run>& runs, CsvTable& table) {
  for (const Run& run : runs) {
    const RunFacts facts = summarise_run(run);
    table.add({scene.name, std::to_string(size.triangles), run.entrant.engine, run.entrant.settings,
               run.entrant.bound ? cell(*run.entrant.bound) : "", to_name(run.end), std::to_string(run.frames.size()),
               cell(facts.median_ms), cell(facts.mean_ms), cell(facts.p99_ms), cell(facts.stretch),
               cell(facts.p99_stretch), cell(facts.surface_stretch), cell(facts.p99_surface_stretch),
               std::to_string(facts.median_substeps), std::to_string(facts.not_certified)});
  }
}

void run_all(const Options& options) {
  const auto is_wanted = [](const auto& list, const auto& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
  };
  CsvTable table({"scene", "triangles", "engine", "settings", "bound", "end", "frames", "median_ms", "mean_ms",
                  "p99_ms", "max_stretch", "max_p99_stretch", "max_surface_stretch", "max_p99_surface_stretch",
                  "median_substeps", "frames_not_certified"});
  fmt::print(
      "For each bound the fastest setting whose worst edge keeps it in every frame, else the one that comes "
      "closest; substeps x iterations.\n");
  for (const RaceScene& race_scene : race_scenes()) {
    for (const RaceSize& size : race_sizes()) {
      if (!is_wanted(options.scenes, race_scene.name) || !is_wanted(options.sizes, size.triangles)) {
        continue;
      }
      const Scene scene = make_race_scene(race_scene, size);
      const int frames = std::max(1, static_cast<int>(std::lround(options.seconds * scene.simulation.frame_rate_hz)));
      fmt::print("\n{}, {} triangles, {} frames\n", race_scene.name, size.triangles, frames);
      const auto runs = race(entrants_for(options), load_garment(scene), scene,
                             {.frames = frames, .slowest_frame_ms = options.slowest_frame_ms});
      print_heat(runs, options);
      add_rows(race_scene, size, runs, table);
    }
  }
  if (!options.csv.empty()) {
    write_text_file(options.csv, table.text());
  }
}

}  // namespace
}  // namespace taut::app

int main(int count, char** words) {
  taut::app::Options options;
  CLI::App app("Time for a frame against stretch, side by side with Bullet");
  app.add_option("--sizes", options.sizes, "triangles: some of 1028,5280,10600,42400,84480")->delimiter(',');
  app.add_option("--scenes", options.scenes, "some of hanging,shaken,wind")->delimiter(',');
  app.add_option("--engines", options.engines, "some of bounded,bullet,strong")
      ->delimiter(',')
      ->check(CLI::IsMember(taut::app::engine_names()));
  app.add_option("--bounds", options.bounds, "largest stretches to be kept")->delimiter(',');
  app.add_option("--seconds", options.seconds, "simulated time");
  app.add_option("--limit", options.slowest_frame_ms, "ms per frame above which a setting is given up");
  app.add_flag("--full", options.full, "more settings of each engine");
  app.add_flag("--ablation", options.ablation, "bounded, also without one of its parts at a time");
  app.add_option("--csv", options.csv, "file for all runs");
  CLI11_PARSE(app, count, words);
  taut::app::run_all(options);
}
