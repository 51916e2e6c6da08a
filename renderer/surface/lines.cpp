#include "renderer/surface/lines.hpp"

namespace taut::renderer {
namespace {

// Rows of numbers for each vertex, one after the other (compressed sparse rows).
struct Rows {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> items;

  // `fill` calls what it is handed with a vertex and an item, the same ones every time.
  template <class Fill> Rows(std::size_t vertex_count, const Fill& fill) : offsets(vertex_count + 1) {
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

  Lines made() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (const std::uint32_t end : edges_[e]) {
        if (at_vertex_[end].size() != 2) follow(end, e);
      }
    }
    // The rest goes around.
    for (std::uint32_t e = 0; e < edges_.size(); ++e) follow(edges_[e][0], e);
    return std::move(lines_);
  }

 private:
  void follow(std::uint32_t vertex, std::uint32_t edge) {
    if (done_[edge]) return;
    Lines::Chain chain{.first_segment = static_cast<std::uint32_t>(lines_.segments.size())};
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
  Rows at_vertex_;
  Lines lines_;
};

// Spreads from the lines as a front, nearest first (Dijkstra 1959).
class Front {
 public:
  Front(const Lines& lines, std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles, float reach)
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
    const Lines::Chain& chain = lines_.chains[lines_.segments[segment].chain];
    const std::uint32_t place = segment - chain.first_segment;
    for (const std::uint32_t step : {0U, 1U, chain.segment_count - 1U}) {
      const std::uint32_t other = (place + step) % chain.segment_count;
      offer(vertex, chain.first_segment + other);
    }
  }

  void offer(std::uint32_t vertex, std::uint32_t segment) {
    const Lines::Segment& own = lines_.segments[segment];
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

  const Lines& lines_;
  std::span<const glm::vec3> positions_;
  float reach_;
  std::vector<NearestOnLine> found_;
  Rows neighbours_;
  std::priority_queue<std::pair<float, std::uint32_t>> queue_;
};

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
        nearest(
            nearest_on_lines(lines, positions, mesh.triangles(), reach + longest_side(positions, mesh.triangles()))),
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
      if (std::abs(own.along - straight) < most) return {own.distance, scale * own.along};
    }
    return {own.distance, scale * straight};
  }

  // On which side of its line a triangle is.
  float side_of(const std::array<std::uint32_t, 3>& corners, const NearestOnLine& main) const {
    const glm::vec3 &a = rest_positions[corners[0]], &b = rest_positions[corners[1]], &c = rest_positions[corners[2]];
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

Lines lines_of(std::span<const VertexPair> edges, std::span<const glm::vec3> rest_positions) {
  return ChainMaker(edges, rest_positions).made();
}

std::vector<NearestOnLine> nearest_on_lines(const Lines& lines, std::span<const glm::vec3> rest_positions,
                                            std::span<const std::uint32_t> triangles, float reach) {
  return Front(lines, rest_positions, triangles, reach).spread();
}

std::vector<TrimmedTriangle> trimmed_triangles(const SmoothSurface& surface, std::span<const glm::vec3> rest_positions,
                                               const SewingPlan& plan) {
  const RefinedMesh& mesh = surface.mesh();
  const Trimming border(border_of(mesh), rest_positions, mesh, reach_of(plan.bands), plan.stitch_m);
  const Trimming seam(mesh.refined_edges(plan.seams), rest_positions, mesh, reach_of_seam * plan.stitch_m,
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
      const glm::vec2 hem = band.width_m == 0.0F ? glm::vec2{far_m, 0} : border.place_of(corners[i], *at_border);
      const glm::vec2 sewn = at_seam == nullptr ? glm::vec2{far_m, 0} : seam.place_of(corners[i], *at_seam);
      own.corners[i] = {on_rim[i] ? -plan.thickness_m : hem.x, hem.y, side * sewn.x, sewn.y};
    }
  }
  return trimmed;
}

}  // namespace taut::renderer
