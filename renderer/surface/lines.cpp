#include "renderer/surface/lines.hpp"

namespace taut::renderer {
namespace {

// Items per vertex in compressed sparse rows.
struct VertexRows {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> items;

  // `fill` calls its argument with each vertex and item, equally at every call.
  template <class Fill> VertexRows(std::size_t vertex_count, const Fill& fill) : offsets(vertex_count + 1) {
    fill([&](std::uint32_t vertex, std::uint32_t) { ++offsets[vertex + 1]; });
    for (std::size_t v = 0; v < vertex_count; ++v) offsets[v + 1] += offsets[v];
    items.resize(offsets.back());
    std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
    fill([&](std::uint32_t vertex, std::uint32_t item) { items[next[vertex]++] = item; });
  }
  std::span<const std::uint32_t> operator[](std::size_t vertex) const {
    return std::span(items).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

class ChainMaker {
 public:
  ChainMaker(std::span<const VertexPair> edges, std::span<const glm::vec3> positions)
      : edges_(edges), positions_(positions), done_(edges.size()), at_vertex_(positions.size(), [&](auto add) {
          for (std::uint32_t e = 0; e < edges.size(); ++e) {
            for (const std::uint32_t end : edges[e]) add(end, e);
          }
        }) {}

  LineChains make_chains() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (const std::uint32_t end : edges_[e]) {
        if (at_vertex_[end].size() != 2) follow(end, e);
      }
    }
    // The remaining chains are closed.
    for (std::uint32_t e = 0; e < edges_.size(); ++e) follow(edges_[e][0], e);
    return std::move(lines_);
  }

 private:
  void follow(std::uint32_t vertex, std::uint32_t edge) {
    if (done_[edge]) return;
    LineChains::Chain chain{.first_segment = static_cast<std::uint32_t>(lines_.segments.size())};
    const std::uint32_t first_vertex = vertex;
    while (!done_[edge]) {
      done_[edge] = true;
      const std::uint32_t end = edges_[edge][edges_[edge][0] == vertex ? 1 : 0];
      lines_.segments.push_back({{vertex, end}, chain.length, static_cast<std::uint32_t>(lines_.chains.size())});
      chain.length += glm::distance(positions_[vertex], positions_[end]);
      ++chain.segment_count;
      vertex = end;
      const std::span<const std::uint32_t> row = at_vertex_[vertex];
      if (row.size() == 2) edge = row[0] == edge ? row[1] : row[0];
    }
    chain.is_closed = vertex == first_vertex;
    lines_.chains.push_back(chain);
  }

  std::span<const VertexPair> edges_;
  std::span<const glm::vec3> positions_;
  std::vector<bool> done_;
  VertexRows at_vertex_;
  LineChains lines_;
};

// Front that spreads from the lines, nearest vertex first (Dijkstra 1959).
class LineFront {
 public:
  LineFront(const LineChains& lines, std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
            float reach)
      : lines_(lines),
        positions_(positions),
        reach_(reach),
        found_(positions.size()),
        neighbours_(positions.size(), [&](auto add) {
          for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const std::uint32_t next = triangles[next_corner(i)];
            add(triangles[i], next);
            add(next, triangles[i]);
          }
        }) {}

  std::vector<NearestOnLine> spread() {
    for (std::uint32_t s = 0; s < lines_.segments.size(); ++s) {
      for (const std::uint32_t end : lines_.segments[s].ends) offer(end, s);
    }
    while (!queue_.empty()) {
      const auto [minus_distance, vertex] = queue_.top();
      queue_.pop();
      if (-minus_distance > found_[vertex].distance) continue;
      const std::uint32_t segment = found_[vertex].segment;
      for (const std::uint32_t neighbour : neighbours_[vertex]) offer_around(neighbour, segment);
    }
    return std::move(found_);
  }

 private:
  void offer_around(std::uint32_t vertex, std::uint32_t segment) {
    const LineChains::Chain& chain = lines_.chains[lines_.segments[segment].chain];
    const std::uint32_t place = segment - chain.first_segment;
    for (const std::uint32_t step : {0U, 1U, chain.segment_count - 1U}) {
      const std::uint32_t other = (place + step) % chain.segment_count;
      offer(vertex, chain.first_segment + other);
    }
  }

  void offer(std::uint32_t vertex, std::uint32_t segment) {
    const LineChains::ChainSegment& own = lines_.segments[segment];
    const glm::vec3 start = positions_[own.ends[0]];
    const glm::vec3 way = positions_[own.ends[1]] - start;
    const float squared = glm::dot(way, way);
    const glm::vec3 to = positions_[vertex] - start;
    const float share = squared > 0.0F ? glm::clamp(glm::dot(to, way) / squared, 0.0F, 1.0F) : 0.0F;
    const float distance = glm::length(to - share * way);
    if (!(distance < found_[vertex].distance && distance <= reach_)) return;
    found_[vertex] = {segment, distance, own.start + share * std::sqrt(squared)};
    queue_.emplace(-distance, vertex);
  }

  const LineChains& lines_;
  std::span<const glm::vec3> positions_;
  float reach_;
  std::vector<NearestOnLine> found_;
  VertexRows neighbours_;
  std::priority_queue<std::pair<float, std::uint32_t>> queue_;
};

// Reach of trims beyond a band, in band widths, and beside a seam, in stitches.
constexpr float band_reach_ratio = 1.35F;
constexpr float seam_reach_stitches = 1.5F;
// Distance of corners without a line, metres.
constexpr float far_m = 1.0F;
// Largest difference of a position along a line from that along a straight one: fractions of the path between two
// corners and of an edge of the line. Lower values break stitches in curves, higher ones stretch them across corners.
constexpr float max_curve_ratio = 0.75F;
constexpr float max_shift_ratio = 0.25F;

float max_side_length(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
  float max_length = 0.0F;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    max_length = std::max(max_length, glm::distance(positions[triangles[i]], positions[triangles[next_corner(i)]]));
  }
  return max_length;
}

// Lines, with the nearest point on them of each vertex.
struct Trimming {
  LineChains lines;
  std::vector<NearestOnLine> nearest_places;
  std::span<const glm::vec3> rest_positions;
  float reach_m;
  std::vector<float> stitches_per_m;  // per chain; a closed chain has a whole number of stitches

  // The longest side is added to the reach, so that all corners of a triangle within reach are found.
  Trimming(std::span<const VertexPair> edges, std::span<const glm::vec3> positions, const RefinedMesh& mesh,
           float reach, float stitch_m)
      : lines(make_lines(edges, positions)),
        nearest_places(
            nearest_on_lines(lines, positions, mesh.triangles(), reach + max_side_length(positions, mesh.triangles()))),
        rest_positions(positions),
        reach_m(reach) {
    for (const LineChains::Chain& chain : lines.chains) {
      const float stitches = std::max(std::round(chain.length / stitch_m), 1.0F);
      stitches_per_m.push_back(chain.is_closed ? stitches / chain.length : 1.0F / stitch_m);
    }
  }

  // Returns the nearest line point of the corners; null if no corner is within reach.
  const NearestOnLine* nearest_to_corners(const std::array<std::uint32_t, 3>& corners) const {
    const NearestOnLine* least = &nearest_places[corners[0]];
    for (const std::uint32_t corner : corners) {
      if (nearest_places[corner].distance < least->distance) least = &nearest_places[corner];
    }
    return least->distance < reach_m ? least : nullptr;
  }

  // Returns distance in metres and position in stitches, continuous from corner to corner.
  glm::vec2 stitch_place(std::uint32_t vertex, const NearestOnLine& main) const {
    const LineChains::ChainSegment& segment = lines.segments[main.segment];
    const float scale = stitches_per_m[segment.chain];
    const glm::vec3 start = rest_positions[segment.ends[0]];
    const glm::vec3 way = rest_positions[segment.ends[1]] - start;
    const glm::vec3 to = rest_positions[vertex] - start;
    const float length = std::max(glm::length(way), 1e-12F);
    const float straight = segment.start + glm::dot(to, way) / length;
    const NearestOnLine& own = nearest_places[vertex];
    if (own.segment != NearestOnLine::none && lines.segments[own.segment].chain == segment.chain) {
      const float most = max_curve_ratio * std::abs(straight - main.along) + max_shift_ratio * length;
      if (std::abs(own.along - straight) < most) return {own.distance, scale * own.along};
    }
    return {own.distance, scale * straight};
  }

  // Returns the side of its line that a triangle is on: 1 or -1.
  float line_side(const std::array<std::uint32_t, 3>& corners, const NearestOnLine& main) const {
    const glm::vec3 &a = rest_positions[corners[0]], &b = rest_positions[corners[1]], &c = rest_positions[corners[2]];
    const VertexPair& ends = lines.segments[main.segment].ends;
    const glm::vec3 start = rest_positions[ends[0]];
    const glm::vec3 left = glm::cross(glm::cross(b - a, c - a), rest_positions[ends[1]] - start);
    return glm::dot((a + b + c) / 3.0F - start, left) < 0.0F ? -1.0F : 1.0F;
  }
};

std::vector<VertexPair> border_pairs(const RefinedMesh& mesh) {
  std::vector<VertexPair> edges;
  for (const LinkedBorderEdge& edge : mesh.border()) edges.push_back(edge.ends);
  return edges;
}

std::vector<BorderBand> bands_of_chains(const LineChains& lines, std::span<const BorderBand> bands) {
  std::vector<BorderBand> found(lines.chains.size());
  for (const LineChains::ChainSegment& segment : lines.segments) {
    for (const std::uint32_t end : segment.ends) {
      if (end < bands.size() && found[segment.chain].width_m == 0.0F) found[segment.chain] = bands[end];
    }
  }
  return found;
}

float bands_reach_m(std::span<const BorderBand> bands) {
  float max_width_m = 0.0F;
  for (const BorderBand& band : bands) max_width_m = std::max(max_width_m, band.width_m);
  return band_reach_ratio * max_width_m;
}

}  // namespace

LineChains make_lines(std::span<const VertexPair> edges, std::span<const glm::vec3> rest_positions) {
  return ChainMaker(edges, rest_positions).make_chains();
}

std::vector<NearestOnLine> nearest_on_lines(const LineChains& lines, std::span<const glm::vec3> rest_positions,
                                            std::span<const std::uint32_t> triangles, float reach) {
  return LineFront(lines, rest_positions, triangles, reach).spread();
}

std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface, std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan) {
  const RefinedMesh& mesh = surface.mesh();
  const Trimming border(border_pairs(mesh), rest_positions, mesh, bands_reach_m(plan.bands), plan.stitch_m);
  const Trimming seam(mesh.refined_edges(plan.seams), rest_positions, mesh, seam_reach_stitches * plan.stitch_m,
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
    const NearestOnLine* at_border = border.nearest_to_corners(corners);
    const NearestOnLine* at_seam = seam.nearest_to_corners(corners);
    const BorderBand band =
        at_border == nullptr ? BorderBand{} : bands[border.lines.segments[at_border->segment].chain];
    if (band.width_m == 0.0F && at_seam == nullptr) continue;
    TrimmedTriangle& own = trimmed.emplace_back();
    own.triangle = t;
    own.band_m = band.width_m;
    own.ribbed = band.ribbed;
    own.thickness_m = plan.thickness_m;
    own.stitch_m = plan.stitch_m;
    const float side = at_seam == nullptr ? 1.0F : seam.line_side(corners, *at_seam);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec2 hem = band.width_m == 0.0F ? glm::vec2{far_m, 0} : border.stitch_place(corners[i], *at_border);
      const glm::vec2 sewn = at_seam == nullptr ? glm::vec2{far_m, 0} : seam.stitch_place(corners[i], *at_seam);
      own.corners[i] = {on_rim[i] ? -plan.thickness_m : hem.x, hem.y, side * sewn.x, sewn.y};
    }
  }
  return trimmed;
}

}  // namespace taut::renderer
