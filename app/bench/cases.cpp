#include "app/bench/cases.hpp"

#include <fmt/core.h>

#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {

const std::vector<BenchScene>& bench_scenes() {
  static const std::vector<BenchScene> scenes = {
      {"hanging", "let go and hanging from its neckline", {}},
      {"shaken",
       "its neckline swings sideways by 10 cm once a second",
       {{"pins.motion.amplitude", "[0.1, 0.0, 0.0]"}, {"pins.motion.frequency", "1.0"}}},
      {"wind",
       "in a wind of 10 m/s from behind",
       {{"wind.speed", "10.0"}, {"wind.direction", "[0.3, 0.0, 1.0]"}}},
  };
  return scenes;
}

const std::vector<BenchSize>& bench_sizes() {
  static const std::vector<BenchSize> sizes = {
      {1028, 1028, 0}, {5280, 5280, 0}, {10600, 10600, 0}, {42400, 10600, 1}, {84480, 5280, 2}};
  return sizes;
}

std::vector<std::string> bench_scene_names() {
  std::vector<std::string> names;
  for (const BenchScene& scene : bench_scenes()) {
    names.push_back(scene.name);
  }
  return names;
}

std::vector<Setting> settings_of(const BenchScene& scene, const BenchSize& size) {
  std::vector<Setting> settings = {
      {"garment.subdivisions", std::to_string(size.subdivisions)},
      {"pins.at", R"(["front_neckline", "back_neckline"])"},
      // Contact is another matter, and no peer has it here.
      {"solver.contact", "false"},
  };
  settings.insert(settings.end(), scene.settings.begin(), scene.settings.end());
  return settings;
}

Scene make_bench_scene(const BenchScene& bench_scene, const BenchSize& size) {
  Scene scene = find_scene(bench_base_scene, {});
  scene.garment.file = scene.garment.file.parent_path() / fmt::format("tshirt_{}.obj", size.model);
  return with_settings(std::move(scene), settings_of(bench_scene, size));
}

Scene with_settings(Scene scene, const std::vector<Setting>& settings) {
  std::vector<Override> overrides;
  for (const auto& [key, value] : settings) {
    overrides.push_back({key, value, fmt::format("{}={}", key, value)});
  }
  apply_overrides(simulation_format(), overrides, scene);
  return scene;
}

}  // namespace taut::app
