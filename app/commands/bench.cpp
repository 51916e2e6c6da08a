#include "app/bench/bench.hpp"

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/commands/options.hpp"

namespace taut::app {
namespace {

std::vector<ContactCase> wanted_cases(const BenchOptions& options) {
  std::vector<ContactCase> cases = options.contact && !options.quick ? all_contact_cases() : quick_contact_cases();
  const std::vector<std::string> all = collect<std::string>(cases, &ContactCase::name);
  for (const std::string& name : options.scenes) {
    if (std::ranges::find(all, name) == all.end()) {
      throw UsageError("--scenes: found '" + name + '\'' + did_you_mean(name, all) + "; expected some of " +
                       join(all, ","));
    }
  }
  std::erase_if(cases, [&](const ContactCase& one) {
    return !options.scenes.empty() && std::ranges::find(options.scenes, one.name) == options.scenes.end();
  });
  return cases;
}

ContactTrial run_trial(const ContactCase& one, const BenchOptions& options, Progress* progress) {
  ContactTrial trial = {one.name, 0.0, 0, {}};
  for (const std::vector<std::string>& settings : one.runs) {
    Scene scene = find_scene(one.scene, collect<Override>(settings, parse_override));
    scene.simulation.solver.bounded.vector_unit = measured_vector_unit();
    scene.simulation.solver.bounded.threads = options.threads;
    const std::vector<sim::Body> bodies = load_bodies(scene).all;
    const LoadedGarment loaded = load_garment(scene);
    trial.bound = stretch_bound(scene).value_or(0.0);
    trial.triangles = loaded.garment->mesh.triangles.size();
    const int frames = options.frames.value_or(one.frames.value_or(scene.frames));
    for (int run = 1; run <= options.runs.value_or(1); ++run) {
      const auto seed = static_cast<std::uint64_t>(options.runs ? run : 0);
      trial.runs.push_back(
          run_contact(scene, loaded, bodies, frames, seed, [&](int frame, sim::Simulation& simulation) {
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

}  // namespace

int run(const BenchOptions& options) {
  const std::vector<ContactCase> cases = wanted_cases(options);
  const bool shows_table = !options.csv && !options.quiet;
  std::vector<ContactTrial> trials;
  std::optional<Progress> progress;
  if (!options.quiet) progress.emplace("bench");
  Progress* const shown = progress ? &*progress : nullptr;
  if (shows_table) print(contact_head(sim::to_name(measured_vector_unit()), options.threads), shown);
  for (const ContactCase& one : cases) {
    trials.push_back(run_trial(one, options, shown));
    if (shows_table) print(contact_row(trials.back()), shown);
  }
  if (options.csv) print(contact_csv(trials), shown);
  const bool have_all_passed = std::ranges::all_of(
      trials, [](const ContactTrial& trial) { return summarise_contact(trial.runs).passed_runs == trial.runs.size(); });
  return have_all_passed ? 0 : exit_promise_broken;
}

}  // namespace taut::app
