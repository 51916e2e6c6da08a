#include "renderer/surface/trims.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/surface/lines.hpp"

namespace taut::renderer {

namespace {

// How far what is sewn shows beyond a band, times its width, and beside a seam, stitches.
constexpr float reach_of_band = 1.35F;
constexpr float reach_of_seam = 1.5F;
// Of what is on no line, metres.
constexpr float far_m = 1.0F;
// By how much a place along a line may differ from that along a straight one: shares of the way between two
// corners and of an edge of the line. Less breaks stitches in curves, more stretches them across corners.
constexpr float most_curved = 0.75F;
constexpr float most_shifted = 0.25F;

float longest_side(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
  float longest = 0.0F;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    longest = std::max(longest, glm::distance(positions[triangles[i]], positions[triangles[next_corner(i)]]));
  }
  return longest;
}

// Lines, and where on them each vertex is nearest.
struct Trimming {
  Lines lines;
  std::vector<NearestOnLine> nearest;
  std::span<const glm::vec3> rest_positions;
  float reach_m;
  std::vector<float> stitches_per_m;  // of each chain: a whole number goes around

  // All corners of a triangle within reach are found.
  Trimming(std::span<const VertexPair> edges, std::span<const glm::vec3> positions, const RefinedMesh& mesh,
           float reach, float stitch_m)
      : lines(lines_of(edges, positions)),
        nearest(nearest_on_lines(lines, positions, mesh.triangles(),
                                 reach + longest_side(positions, mesh.triangles()))),
        rest_positions(positions),
        reach_m(reach) {
    for (const Lines::Chain& chain : lines.chains) {
      const float stitches = std::max(std::round(chain.length / stitch_m), 1.0F);
      stitches_per_m.push_back(chain.is_closed ? stitches / chain.length : 1.0F / stitch_m);
    }
  }

  // The corner that is nearest to a line; none if no corner is near one.
  const NearestOnLine* nearest_of(const std::array<std::uint32_t, 3>& corners) const {
    const NearestOnLine* least = &nearest[corners[0]];
    for (const std::uint32_t corner : corners) {
      if (nearest[corner].distance < least->distance) least = &nearest[corner];
    }
    return least->distance < reach_m ? least : nullptr;
  }

  // Distance in metres and place in stitches, such that they go on evenly from corner to corner.
  glm::vec2 place_of(std::uint32_t vertex, const NearestOnLine& main) const {
    const Lines::Segment& segment = lines.segments[main.segment];
    const float scale = stitches_per_m[segment.chain];
    const glm::vec3 start = rest_positions[segment.ends[0]];
    const glm::vec3 way = rest_positions[segment.ends[1]] - start;
    const glm::vec3 to = rest_positions[vertex] - start;
    const float length = std::max(glm::length(way), 1e-12F);
    const float straight = segment.start + glm::dot(to, way) / length;
    const NearestOnLine& own = nearest[vertex];
    if (own.segment != NearestOnLine::none && lines.segments[own.segment].chain == segment.chain) {
      const float most = most_curved * std::abs(straight - main.along) + most_shifted * length;
      if (std::abs(own.along - straight) < most) {
        return {own.distance, scale * own.along};
      }
    }
    return {own.distance, scale * straight};
  }

  // On which side of its line a triangle is.
  float side_of(const std::array<std::uint32_t, 3>& corners, const NearestOnLine& main) const {
    const glm::vec3 &a = rest_positions[corners[0]], &b = rest_positions[corners[1]],
                    &c = rest_positions[corners[2]];
    const VertexPair& ends = lines.segments[main.segment].ends;
    const glm::vec3 start = rest_positions[ends[0]];
    const glm::vec3 left = glm::cross(glm::cross(b - a, c - a), rest_positions[ends[1]] - start);
    return glm::dot((a + b + c) / 3.0F - start, left) < 0.0F ? -1.0F : 1.0F;
  }
};

std::vector<VertexPair> border_of(const RefinedMesh& mesh) {
  std::vector<VertexPair> edges;
  for (const BorderEdge& edge : mesh.border()) edges.push_back(edge.ends);
  return edges;
}

std::vector<VertexPair> fine_seams(const RefinedMesh& mesh, std::span<const VertexPair> seams) {
  std::vector<std::uint32_t> flat;
  for (const VertexPair& seam : seams) flat.insert(flat.end(), seam.begin(), seam.end());
  flat = mesh.refined_edges(flat);
  std::vector<VertexPair> edges;
  for (std::size_t i = 0; i < flat.size(); i += 2) edges.push_back({flat[i], flat[i + 1]});
  return edges;
}

std::vector<BorderBand> bands_of_chains(const Lines& lines, std::span<const BorderBand> bands) {
  std::vector<BorderBand> found(lines.chains.size());
  for (const Lines::Segment& segment : lines.segments) {
    for (const std::uint32_t end : segment.ends) {
      if (end < bands.size() && found[segment.chain].width_m == 0.0F) found[segment.chain] = bands[end];
    }
  }
  return found;
}

float reach_of(std::span<const BorderBand> bands) {
  float widest_m = 0.0F;
  for (const BorderBand& band : bands) widest_m = std::max(widest_m, band.width_m);
  return reach_of_band * widest_m;
}

}  // namespace

std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface,
                                               std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan) {
  const RefinedMesh& mesh = surface.mesh();
  const Trimming border(border_of(mesh), rest_positions, mesh, reach_of(plan.bands), plan.stitch_m);
  const Trimming seam(fine_seams(mesh, plan.seams), rest_positions, mesh, reach_of_seam * plan.stitch_m,
                      plan.stitch_m);
  const std::vector<BorderBand> bands = bands_of_chains(border.lines, plan.bands);
  std::vector<TrimmedTriangle> trimmed;
  for (std::uint32_t t = 0; t < surface.triangles().size() / 3; ++t) {
    std::array<std::uint32_t, 3> corners{};
    std::array<bool, 3> on_rim{};
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners[i] = surface.triangles()[3 * t + i];
      on_rim[i] = corners[i] >= mesh.vertex_count();
      if (on_rim[i]) corners[i] = surface.parents()[corners[i] - mesh.coarse_vertex_count()][0];
    }
    const NearestOnLine* at_border = border.nearest_of(corners);
    const NearestOnLine* at_seam = seam.nearest_of(corners);
    const BorderBand band =
        at_border == nullptr ? BorderBand{} : bands[border.lines.segments[at_border->segment].chain];
    if (band.width_m == 0.0F && at_seam == nullptr) continue;
    TrimmedTriangle& own = trimmed.emplace_back();
    own.triangle = t;
    own.band_m = band.width_m;
    own.ribbed = band.ribbed;
    own.thickness_m = plan.thickness_m;
    own.stitch_m = plan.stitch_m;
    const float side = at_seam == nullptr ? 1.0F : seam.side_of(corners, *at_seam);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec2 hem =
          band.width_m == 0.0F ? glm::vec2{far_m, 0} : border.place_of(corners[i], *at_border);
      const glm::vec2 sewn = at_seam == nullptr ? glm::vec2{far_m, 0} : seam.place_of(corners[i], *at_seam);
      own.corners[i] = {on_rim[i] ? -plan.thickness_m : hem.x, hem.y, side * sewn.x, sewn.y};
    }
  }
  return trimmed;
}

}  // namespace taut::renderer
