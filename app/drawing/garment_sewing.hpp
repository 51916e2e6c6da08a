#pragma once

#include "renderer/surface/lines.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// Returns the position of each corner of the garment's triangles on its flat piece of cloth, three per triangle, in
/// metres: v along the warp, u to the right as seen from outside. Each piece between seams is scaled so that its area
/// in texture coordinates becomes its area at rest, and is flipped if it is mirrored. Empty without texture coordinates
/// or if a piece has no area in them.
std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv);

/// Edge finish and seams of a garment. They are drawn, not simulated.
struct GarmentSewing {
  std::vector<renderer::BorderBand> bands;  ///< one per vertex, or none
  std::vector<renderer::VertexPair> seams;
  float stitch_m = 0.004F;
  float rim_radius_m = 0.0005F;  ///< half the thickness at the border
};

/// Finds edge finish and seams of the garment at rest. Openings get hems, the neck a ribbed band; both are narrower on
/// small garments. A grid is plain cloth without them. Seams are edges across which `corner_coordinates`, three texture
/// coordinates per triangle, differ; without coordinates they are long sharp edges.
GarmentSewing make_garment_sewing(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates = {});

}  // namespace taut::app
