#pragma once

#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "app/drawing/offscreen_renderer.hpp"
#include "app/frame_loop.hpp"

namespace taut::app {

/// Ends a run with what blocked its last frame: writes a picture of the frame before to a file of a new name
/// and throws PromiseBroken, which names both. `pattern` is where the run's files go: the picture goes beside
/// them where each frame has its own, or else into the working folder. Without a picture the message says
/// why.
[[noreturn]] void end_blocked(const FrameBlocked& error, const DrawnScene& scene,
                              const sim::Simulation& simulation, const std::string& pattern,
                              OffscreenRenderer& offscreen);

/// The same, with OpenGL started for it.
[[noreturn]] void end_blocked(const FrameBlocked& error, const DrawnScene& scene,
                              const sim::Simulation& simulation, const std::string& pattern);

}  // namespace taut::app
