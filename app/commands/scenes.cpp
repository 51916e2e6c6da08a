#include <fmt/core.h>

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"

namespace taut::app {

int run(const ScenesOptions&) {
  const std::vector<BuiltInScene> scenes = built_in_scenes();
  if (scenes.empty()) {
    throw InputError("no built-in scenes were found; set TAUT_ASSETS to the folder that holds scenes/");
  }
  for (const BuiltInScene& scene : scenes) {
    fmt::print("{:<16} {}\n", scene.name, read_scene_file(scene.file).title);
  }
  return 0;
}

int run(const HelpOptions& options) {
  fmt::print("{}", options.text);
  return 0;
}

}  // namespace taut::app
