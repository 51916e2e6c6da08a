#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace taut::app {

/// One key of a scene and its value, as on the command line.
struct Setting {
  std::string key;
  std::string value;
};

/// What happens to the shirt in a scene of the benchmark.
struct BenchScene {
  std::string name;
  std::string meaning;
  std::vector<Setting> settings;
};

/// A model and how often it is subdivided.
struct BenchSize {
  int triangles = 0;
  int model = 0;
  int subdivisions = 0;
};

const std::vector<BenchScene>& bench_scenes();
const std::vector<BenchSize>& bench_sizes();

std::vector<std::string> bench_scene_names();

/// The settings that make the built-in scene `bench_base_scene` the one that is measured.
inline constexpr const char* bench_base_scene = "tshirt-gravity";
std::vector<Setting> settings_of(const BenchScene& scene, const BenchSize& size);

/// Throws InputError where the garment is missing.
Scene make_bench_scene(const BenchScene& scene, const BenchSize& size);

/// A copy of the scene with the settings. Throws UsageError.
Scene with_settings(Scene scene, const std::vector<Setting>& settings);

}  // namespace taut::app
