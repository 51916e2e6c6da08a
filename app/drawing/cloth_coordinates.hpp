#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "sim/garment.hpp"

namespace taut::app {

/// Returns where on its flat piece of cloth each corner of the garment's triangles lies, three each, in
/// metres: v along the warp, u to the right of it seen from outside. Each run of triangles without a seam has
/// the scale that gives its texture coordinates its area at rest, and is turned over if they are mirrored.
/// Returns none without coordinates, or if a run has no area in them.
std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv);

}  // namespace taut::app
