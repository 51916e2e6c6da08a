#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sim/wind.hpp"

namespace taut::app {

/// Arrows of a wind that blows at a garment with these positions, in metres: line segments, two points each,
/// on the side it comes from. Twice as long for twice the speed, up to the size of the garment. Without wind
/// there are none. Gusts are not shown.
std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions);

}  // namespace taut::app
