#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "renderer/surface/trims.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// How the edges of a garment are finished and where it has seams. It is drawn, not simulated.
struct GarmentSewing {
  std::vector<renderer::BorderBand> bands;  ///< one per vertex, or none
  std::vector<renderer::VertexPair> seams;
  float stitch_m = 0.004F;
  float rim_radius_m = 0.0005F;  ///< half of the thickness at the border
};

/// Finds it by the garment at rest. Openings get hems, and one around the neck a ribbed band: narrower ones
/// where the garment is small. A grid is plain cloth without any. corner_coordinates: texture coordinates,
/// three for each triangle; they differ at seams. Without them, long sharp edges are seams.
GarmentSewing sewing_of(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates = {});

}  // namespace taut::app
