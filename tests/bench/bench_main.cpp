#include <CLI/CLI.hpp>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "tests/bench/bench.hpp"

// bench: the time of a frame, its stretch, and whether any frame breaks a promise.

namespace taut::app {
namespace {

struct BenchOptions {
  std::vector<std::string> scenes;  ///< rows of the table; empty: all
  bool contact = false;             ///< all scenes about contact, instead of the quick ones
  bool quick = false;               ///< those that decide about real time, whatever `contact` is
  std::optional<int> runs;          ///< of each scene, each from a start of its own; empty: one, from the scene's
  std::optional<int> frames;        ///< of each run; empty: as the scene has it
  bool csv = false;
  bool quiet = false;
};

std::vector<ContactCase> wanted_cases(const BenchOptions& options) {
  std::vector<ContactCase> cases = options.contact && !options.quick ? all_contact_cases() : quick_contact_cases();
  std::vector<std::string> all;
  std::ranges::transform(cases, std::back_inserter(all), [](const ContactCase& one) { return one.name; });
  for (const std::string& name : options.scenes) {
    if (std::ranges::find(all, name) == all.end()) {
      throw UsageError("--scenes: found '" + name + '\'' + did_you_mean(name, all) + "; expected some of " +
                       joined(all, ","));
    }
  }
  std::erase_if(cases, [&](const ContactCase& one) {
    return !options.scenes.empty() && std::ranges::find(options.scenes, one.name) == options.scenes.end();
  });
  return cases;
}

ContactTrial run_trial(const ContactCase& one, const BenchOptions& options, Progress* progress) {
  ContactTrial trial = {one.name, 0.0, 0, {}};
  for (const std::vector<Setting>& settings : one.runs) {
    Scene scene = with_settings(find_scene(one.scene, {}), settings);
    scene.simulation.solver.bounded.vector_unit = measured_vector_unit();
    load_bodies(scene);
    const LoadedGarment loaded = load_garment(scene);
    trial.bound = stretch_bound(scene).value_or(0.0);
    trial.triangles = loaded.garment->mesh.triangles.size();
    const int frames = options.frames.value_or(one.frames.value_or(scene.frames));
    for (int run = 1; run <= options.runs.value_or(1); ++run) {
      const auto seed = static_cast<std::uint64_t>(options.runs ? run : 0);
      trial.runs.push_back(run_contact(scene, loaded, frames, seed, [&](int frame, sim::Simulation& simulation) {
        throw_if_interrupted();
        if (one.drags_wind) drag_wind(frame, frames, scene.surroundings.forces.wind.speed_m_per_s, simulation);
        if (progress != nullptr) {
          progress->show(fmt::format("{}, run {}: frame {} of {}", one.name, trial.runs.size() + 1, frame, frames));
        }
      }));
    }
  }
  return trial;
}

void print(const std::string& text, Progress* progress) {
  if (progress != nullptr) progress->hide();
  fmt::print("{}", text);
  std::fflush(stdout);
}

int run(const BenchOptions& options) {
  const std::vector<ContactCase> cases = wanted_cases(options);
  const bool shows_table = !options.csv && !options.quiet;
  std::vector<ContactTrial> trials;
  std::optional<Progress> progress;
  if (!options.quiet) progress.emplace("bench");
  Progress* const shown = progress ? &*progress : nullptr;
  if (shows_table) print(contact_head(sim::name_of(measured_vector_unit())), shown);
  for (const ContactCase& one : cases) {
    trials.push_back(run_trial(one, options, shown));
    if (shows_table) print(contact_row(trials.back()), shown);
  }
  if (options.csv) print(contact_csv(trials), shown);
  const bool have_all_passed = std::ranges::all_of(
      trials, [](const ContactTrial& trial) { return facts_of(trial.runs).passed == trial.runs.size(); });
  return have_all_passed ? 0 : exit_promise_broken;
}

}  // namespace
}  // namespace taut::app

int main(int argument_count, char** arguments) {
  using namespace taut::app;
  CLI::App app(
      "The time of a frame, its stretch, and whether any frame breaks a promise: then it ends with exit code 3",
      "bench");
  BenchOptions options;
  app.add_flag("--contact", options.contact, "all scenes about contact and being worn: takes an hour");
  app.add_flag("--quick", options.quick,
               "a shirt that hangs, in winds, in one that is dragged up and back, and on someone who walks, on one "
               "thread: three minutes at most (default)");
  app.add_option("--scenes", options.scenes, "some of the rows alone")->delimiter(',');
  app.add_option("--runs", options.runs,
                 "so many runs of each scene, each with its start moved at random by a twentieth of the cloth's "
                 "thickness (default: one run of the scene as it is)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--frames", options.frames, "frames of each run (default: as the scene has it)")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--csv", options.csv, "print a table (CSV) of all runs instead");
  app.add_flag("--quiet", options.quiet, "print neither progress nor the table");
  CLI11_PARSE(app, argument_count, arguments);
  try {
    watch_for_interruption();
    return run(options);
  } catch (const Interrupted& interrupted) {
    end_by_signal(interrupted.signal);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: error: %s\n", error.what());
    return exit_bad_input;
  }
}
