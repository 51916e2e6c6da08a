#include "app/drawing/garment_sewing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/drawing/framing.hpp"
#include "app/drawing/mesh_arrays.hpp"
#include "app/models/garment_measures.hpp"
#include "app/models/garment_parts.hpp"
#include "renderer/surface/lines.hpp"
#include "renderer/surface/seams.hpp"

namespace taut::app {
namespace {

// Of a garment for an adult; others have a share of it.
constexpr float hem_m = 0.02F;
constexpr float neckband_m = 0.018F;
constexpr double diagonal_of_adult_m = 0.8;
constexpr float least_share = 0.25F;
// A hem is no wider than this share of its length: small holes have narrow ones.
constexpr float most_of_length = 1.0F / 12.0F;

// Sharp edges shorter than this, stitches, are folds of the model and no seams.
constexpr float shortest_seam = 25.0F;

std::vector<renderer::VertexPair> long_ones(std::span<const renderer::VertexPair> edges,
                                            std::span<const glm::vec3> rest_positions, float shortest_m) {
  const renderer::Lines lines = renderer::lines_of(edges, rest_positions);
  std::vector<renderer::VertexPair> kept;
  for (const renderer::Lines::Segment& segment : lines.segments) {
    if (lines.chains[segment.chain].length >= shortest_m) {
      kept.push_back(segment.ends);
    }
  }
  return kept;
}

bool is_around_neck(const Opening& opening, const GarmentMarks& marks) {
  return marks.top && !marks.is_worn_at_waist && opening.range.lower == marks.top->lower &&
         opening.range.upper == marks.top->upper;
}

std::vector<renderer::BorderBand> bands_of(const sim::Garment& garment, float share) {
  const GarmentMarks marks = marks_of(garment, garment.mesh.positions, {});
  std::vector<renderer::BorderBand> bands(garment.mesh.positions.size());
  for (const GarmentPart& part : parts_of(garment.mesh, garment.adjacency)) {
    for (const Opening& opening : part.openings) {
      const bool ribbed = is_around_neck(opening, marks);
      const float width_m = std::min(share * (ribbed ? neckband_m : hem_m),
                                     most_of_length * static_cast<float>(opening.length_m));
      for (const sim::Index vertex : opening.vertices) {
        bands[vertex] = {width_m, ribbed};
      }
    }
  }
  return bands;
}

}  // namespace

GarmentSewing sewing_of(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates) {
  GarmentSewing sewing;
  sewing.rim_radius_m = 0.5F * static_cast<float>(garment.material.thickness_m);
  if (!garment.mesh.quads.empty()) {
    return sewing;
  }
  const double diagonal_m = glm::length(sim::extent_of(garment.mesh.positions).size());
  const float share = std::clamp(static_cast<float>(diagonal_m / diagonal_of_adult_m), least_share, 1.0F);
  sewing.stitch_m *= share;
  sewing.rim_radius_m *= 2.0F;
  sewing.bands = bands_of(garment, share);
  const std::vector<glm::vec3> rest_positions = to_float(garment.mesh.positions);
  sewing.seams = renderer::seam_edges(rest_positions, flat(garment.mesh.triangles), corner_coordinates);
  if (corner_coordinates.empty()) {
    sewing.seams = long_ones(sewing.seams, rest_positions, shortest_seam * sewing.stitch_m);
  }
  return sewing;
}

}  // namespace taut::app
