#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "renderer/camera.hpp"
#include "sim/wind.hpp"

namespace taut::app {

/// Arrows of a wind that blows at what is in the box: line segments, two points each, in metres, on the side
/// it comes from. Twice as long for twice the speed, up to the size of the box. Without wind there are none.
/// Gusts are not shown.
std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const renderer::Box& around);

}  // namespace taut::app
