#include "app/figures/shots.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "app/frame_loop.hpp"
#include "app/garment_loading.hpp"
#include "app/garment_painter.hpp"
#include "app/progress.hpp"
#include "app/scene_lookup.hpp"

namespace taut::app {

Scene scene_for_print(const std::string& name, int width_px, int height_px) {
  Scene scene = find_scene(name, {});
  renderer::PictureSettings& settings = scene.picture.settings;
  settings.width_px = width_px;
  settings.height_px = height_px;
  settings.supersampling = 2;
  settings.shadow_map_px = 4096;
  settings.sky_directions = 64;
  return scene;
}

std::vector<Shot> take_shots(Studio& studio, const Scene& scene, std::span<const int> frames) {
  sim::Simulation simulation(load_garment(scene).garment, scene.simulation, scene.surroundings);
  GarmentPainter painter(studio.renderer(), scene, simulation.garment());
  Progress progress(scene.name, frames.back());
  std::vector<Shot> shots;

  FrameOutputs outputs;
  outputs.pictures = frames;
  outputs.draw_picture = [&](const sim::Simulation& moment) { return painter.draw(moment.state().current); };
  outputs.write_picture = [&](int, const renderer::Image& picture) { shots.push_back({picture, {}}); };
  outputs.report = [&](const FrameRecord& record) {
    progress.show(record.frame, record.stretch.max);
    if (std::binary_search(frames.begin(), frames.end(), record.frame)) {
      shots.back().record = record;
    }
  };
  run_frames(simulation, frames.back(), outputs);
  return shots;
}

Shot take_last_shot(Studio& studio, const Scene& scene) {
  return std::move(take_shots(studio, scene, std::array{scene.frames}).front());
}

}  // namespace taut::app
