#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/frame_record.hpp"
#include "app/scene.hpp"
#include "app/studio.hpp"
#include "renderer/image.hpp"

namespace taut::app {

/// A picture of one moment of a run and what was measured then.
struct Shot {
  renderer::Image picture;
  FrameRecord record;
};

/// A built-in scene whose pictures are for print: so large, and supersampled.
Scene scene_for_print(const std::string& name, int width_px, int height_px);

/// Runs the scene up to the last of the frames (ascending) and draws each of them.
std::vector<Shot> take_shots(Studio& studio, const Scene& scene, std::span<const int> frames);

/// The scene at its end.
Shot take_last_shot(Studio& studio, const Scene& scene);

}  // namespace taut::app
