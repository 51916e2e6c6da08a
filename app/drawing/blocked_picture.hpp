#pragma once

#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/page/image.hpp"
#include "renderer/scene_renderer.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// Returns a page that shows the simulation as it is, with what was blocked outlined and its place marked: as
/// the scene is looked at, and from near by. `text` is written above.
renderer::Image draw_blocked(renderer::SceneRenderer& renderer, const DrawnScene& scene,
                             const sim::Simulation& simulation, const sim::BlockedContact& blocked,
                             const std::string& text);

}  // namespace taut::app
