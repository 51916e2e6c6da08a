#include "app/drawing/garment_sewing.hpp"

#include "app/drawing/framing.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/garment_parts.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

sim::Groups find_pieces(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  const std::vector<std::uint32_t> triangles = flat(garment.mesh.triangles);
  const std::vector<renderer::VertexPair> seams =
      renderer::seam_edges(to_float(garment.mesh.positions), triangles, corner_uv);
  const std::vector<renderer::TriangleSide> sides = renderer::sorted_sides(triangles);
  sim::Groups pieces(garment.mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].ends == sides[i + 1].ends && !std::ranges::binary_search(seams, sides[i].ends)) {
      pieces.join(sides[i].number / 3, sides[i + 1].number / 3);
    }
  }
  return pieces;
}

struct Areas {
  double in_m2 = 0.0;
  double in_uv = 0.0;  ///< negative: mirrored
};

// Sizes for an adult's garment. A smaller garment has them times its share of an adult's diagonal, at least
// min_size_factor.
constexpr float hem_m = 0.02F;
constexpr float neckband_m = 0.018F;
constexpr double diagonal_of_adult_m = 0.8;
constexpr float min_size_factor = 0.25F;
// Maximum width of a hem as a fraction of its length, so that small holes get narrow hems.
constexpr float max_hem_length_ratio = 1.0F / 12.0F;

// Minimum length of a seam along sharp edges, in stitches. Shorter sharp edges are folds of the model.
constexpr float min_seam_stitches = 25.0F;

std::vector<renderer::VertexPair> long_edges(std::span<const renderer::VertexPair> edges,
                                             std::span<const glm::vec3> rest_positions, float min_length_m) {
  const renderer::LineChains lines = renderer::make_lines(edges, rest_positions);
  std::vector<renderer::VertexPair> kept_pairs;
  for (const renderer::LineChains::ChainSegment& segment : lines.segments) {
    if (lines.chains[segment.chain].length >= min_length_m) kept_pairs.push_back(segment.ends);
  }
  return kept_pairs;
}

bool is_around_neck(const Opening& opening, const GarmentMarks& marks) {
  return marks.top && !marks.is_worn_at_waist && opening.range.lower == marks.top->lower &&
         opening.range.upper == marks.top->upper;
}

std::vector<renderer::BorderBand> make_border_bands(const sim::Garment& garment, float share) {
  const GarmentMarks marks = find_garment_marks(garment, garment.mesh.positions, {});
  std::vector<renderer::BorderBand> bands(garment.mesh.positions.size());
  for (const GarmentPart& part : find_garment_parts(garment.mesh, garment.adjacency)) {
    for (const Opening& opening : part.openings) {
      const bool ribbed = is_around_neck(opening, marks);
      const float width_m =
          std::min(share * (ribbed ? neckband_m : hem_m), max_hem_length_ratio * static_cast<float>(opening.length_m));
      for (const sim::Index vertex : opening.vertices) bands[vertex] = {width_m, ribbed};
    }
  }
  return bands;
}

}  // namespace

std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  if (corner_uv.empty()) return {};
  const sim::Mesh& mesh = garment.mesh;
  sim::Groups pieces = find_pieces(garment, corner_uv);
  std::vector<Areas> areas(mesh.triangles.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec2 a(corner_uv[3 * t]);
    const glm::dvec2 ab = glm::dvec2(corner_uv[3 * t + 1]) - a, ac = glm::dvec2(corner_uv[3 * t + 2]) - a;
    Areas& own = areas[pieces.find(t)];
    own.in_m2 += triangle_area(mesh.positions, mesh.triangles[t]);
    own.in_uv += 0.5 * (ab.x * ac.y - ab.y * ac.x);
  }
  std::vector<glm::vec2> coordinates;
  coordinates.reserve(corner_uv.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const Areas& own = areas[pieces.find(t)];
    const double scale = std::sqrt(own.in_m2 / std::abs(own.in_uv));
    if (!std::isfinite(scale)) return {};
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      coordinates.emplace_back(std::copysign(scale, own.in_uv) * corner_uv[corner].x, scale * corner_uv[corner].y);
    }
  }
  return coordinates;
}

GarmentSewing make_garment_sewing(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates) {
  GarmentSewing sewing;
  sewing.rim_radius_m = 0.5F * static_cast<float>(garment.material.thickness_m);
  if (!garment.mesh.quads.empty()) return sewing;
  const double diagonal_m = glm::length(sim::compute_extent(garment.mesh.positions).size());
  const float share = std::clamp(static_cast<float>(diagonal_m / diagonal_of_adult_m), min_size_factor, 1.0F);
  sewing.stitch_m *= share;
  sewing.rim_radius_m *= 2.0F;
  sewing.bands = make_border_bands(garment, share);
  const std::vector<glm::vec3> rest_positions = to_float(garment.mesh.positions);
  sewing.seams = renderer::seam_edges(rest_positions, flat(garment.mesh.triangles), corner_coordinates);
  if (corner_coordinates.empty()) {
    sewing.seams = long_edges(sewing.seams, rest_positions, min_seam_stitches * sewing.stitch_m);
  }
  return sewing;
}

}  // namespace taut::app
