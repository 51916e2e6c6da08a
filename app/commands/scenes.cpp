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
  std::size_t width = 0;
  for (const BuiltInScene& scene : scenes) {
    width = std::max(width, scene.name.size());
  }
  bool is_of_contact = scenes.front().is_of_contact;
  for (const BuiltInScene& scene : scenes) {
    fmt::print("{}{:<{}}  {}\n", scene.is_of_contact == is_of_contact ? "" : "\n", scene.name, width,
               read_scene_file(scene.file).title);
    is_of_contact = scene.is_of_contact;
  }
  return 0;
}

int run(const HelpOptions& options) {
  fmt::print("{}", options.text);
  return 0;
}

}  // namespace taut::app
