#include <fmt/core.h>

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"
#include "app/base/progress.hpp"
#include "app/base/suggest.hpp"
#include "app/bench/contact_output.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/models/garment_loading.hpp"
#include "app/scene/promise.hpp"

namespace taut::app {
namespace {

std::vector<std::string> wanted_scenes(const BenchOptions& options) {
  const std::vector<std::string> all = contact_scene_names();
  for (const std::string& name : options.scenes) {
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw UsageError("--scenes: found '" + name + '\'' + did_you_mean(name, all) + "; expected some of " +
                       joined(all, ","));
    }
  }
  return options.scenes.empty() ? all : options.scenes;
}

ContactTrial run_trial(const std::string& name, const BenchOptions& options, Progress* progress) {
  Scene scene = find_scene(name, {});
  load_bodies(scene);
  const LoadedGarment loaded = load_garment(scene);
  ContactTrial trial = {name, stretch_bound(scene).value_or(0.0), loaded.garment->mesh.triangles.size(), {}};
  const int frames = options.frames.value_or(scene.frames);
  for (int run = 1; run <= options.runs.value_or(1); ++run) {
    const auto seed = static_cast<std::uint64_t>(options.runs ? run : 0);
    trial.runs.push_back(run_contact(scene, loaded, frames, seed, [&](int frame) {
      throw_if_interrupted();
      if (progress != nullptr) {
        progress->show(fmt::format("{}, run {} of {}: frame {} of {}", name, run, options.runs.value_or(1),
                                   frame, frames));
      }
    }));
  }
  return trial;
}

}  // namespace

int run_contact_bench(const BenchOptions& options) {
  const std::vector<std::string> scenes = wanted_scenes(options);
  const Machine machine = this_machine("");
  std::vector<ContactTrial> trials;
  {
    std::optional<Progress> progress;
    if (!options.quiet) {
      progress.emplace("bench");
    }
    for (const std::string& name : scenes) {
      trials.push_back(run_trial(name, options, progress ? &*progress : nullptr));
    }
  }
  if (options.json) {
    fmt::print("{}", contact_json(trials, machine));
  } else if (!options.quiet) {
    fmt::print("{}", contact_table(trials));
  }
  const bool have_all_passed = std::all_of(trials.begin(), trials.end(), [](const ContactTrial& trial) {
    return facts_of(trial.runs).passed == trial.runs.size();
  });
  return have_all_passed ? 0 : exit_promise_broken;
}

}  // namespace taut::app
