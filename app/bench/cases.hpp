#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace taut::app {

/// One key of a scene and its value, both written as on the command line.
struct Setting {
  std::string key;
  std::string value;
};

/// A scene of the benchmark: what happens to the T-shirt.
struct BenchScene {
  std::string name;
  std::string meaning;  ///< for people
  std::vector<Setting> settings;
};

/// A size of the garment: a T-shirt model, subdivided some number of times.
struct BenchSize {
  int triangles = 0;     ///< after subdivision
  int model = 0;         ///< triangles of the model file
  int subdivisions = 0;  ///< each makes four triangles of one
};

/// All scenes of the benchmark.
const std::vector<BenchScene>& bench_scenes();
/// All sizes of the benchmark, smallest first.
const std::vector<BenchSize>& bench_sizes();

/// The names of bench_scenes(), in the same order.
std::vector<std::string> bench_scene_names();

/// The built-in scene that every scene of the benchmark is derived from.
inline constexpr const char* bench_base_scene = "tshirt-gravity";
/// The settings that turn `bench_base_scene` into this scene at this size. The model file is not among them.
std::vector<Setting> settings_of(const BenchScene& scene, const BenchSize& size);

/// Returns the scene at this size. Throws InputError if its garment file is missing.
Scene make_bench_scene(const BenchScene& scene, const BenchSize& size);

/// Returns the scene with these settings applied. Throws UsageError for a setting that is not valid.
Scene with_settings(Scene scene, const std::vector<Setting>& settings);

}  // namespace taut::app
