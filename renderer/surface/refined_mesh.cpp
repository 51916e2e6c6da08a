#include "renderer/surface/refined_mesh.hpp"

namespace taut::renderer {
namespace {

// Cosine of the smallest turn of a border at rest that makes a corner.
constexpr float corner_cosine = 0.7071F;
// Largest number of triangles made by refinement: pictures of more would take longer than they are worth.
constexpr std::size_t max_triangles = 400'000;
constexpr int max_levels = 4;

VertexPair order_pair(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// Returns the only edge that starts (end 0) or ends (end 1) at each vertex.
std::vector<std::uint32_t> only_edges(const std::vector<LinkedBorderEdge>& border, std::size_t end,
                                      std::size_t vertex_count) {
  std::vector<std::uint32_t> found(vertex_count, LinkedBorderEdge::none);
  std::vector<std::uint8_t> counts(vertex_count, 0);
  for (std::uint32_t e = 0; e < border.size(); ++e) {
    const std::uint32_t vertex = border[e].ends[end];
    found[vertex] = counts[vertex] == 0 ? e : LinkedBorderEdge::none;
    counts[vertex] = 1;
  }
  return found;
}

void connect(std::vector<LinkedBorderEdge>& border, std::span<const glm::vec3> rest_positions) {
  const std::vector<std::uint32_t> starting = only_edges(border, 0, rest_positions.size());
  const std::vector<std::uint32_t> ending = only_edges(border, 1, rest_positions.size());
  const auto way = [&](const LinkedBorderEdge& edge) {
    return rest_positions[edge.ends[1]] - rest_positions[edge.ends[0]];
  };
  for (std::uint32_t e = 0; e < border.size(); ++e) {
    const std::uint32_t vertex = border[e].ends[1];
    const std::uint32_t after = starting[vertex];
    if (after == LinkedBorderEdge::none || ending[vertex] == LinkedBorderEdge::none) continue;
    border[e].next = after;
    border[after].previous = e;
  }
  for (LinkedBorderEdge& edge : border) {
    const auto turns = [&](std::uint32_t other) {
      if (other == LinkedBorderEdge::none) return true;
      const glm::vec3 own = way(edge);
      const glm::vec3 its = way(border[other]);
      return glm::dot(own, its) < corner_cosine * std::sqrt(glm::dot(own, own) * glm::dot(its, its));
    };
    edge.corners = {turns(edge.previous), turns(edge.next)};
  }
}

constexpr float sharp_cosine = 0.6428F;  // cosine of 50 degrees
// Largest difference of equal coordinates, which may be written with few digits.
constexpr float coordinate_tolerance = 1e-5F;

bool differ(const glm::vec2& a, const glm::vec2& b) {
  return std::abs(a.x - b.x) > coordinate_tolerance || std::abs(a.y - b.y) > coordinate_tolerance;
}

// Vertex of a ring: position in radii along the cloth's normal and out of the cloth, and its normal.
struct RingVertex {
  float up;
  float out;
  float facing_up;
  float facing_out;
};

// Half a circle below the cloth that starts on its outside, closed by a slope back to its inside. It ends slightly
// before the cloth, so that it never comes out on the other side.
constexpr std::array<RingVertex, 4> ring{{{-0.5F, 0.866F, 0.5F, 0.866F},
                                          {-1.5F, 0.866F, -0.5F, 0.866F},
                                          {-2.0F, 0.0F, -1.0F, 0.0F},
                                          {-0.4F, -4.0F, -0.9F, -0.436F}}};

glm::vec3 normalise(const glm::vec3& v) {
  const float squared = glm::dot(v, v);
  return squared > 0.0F && std::isfinite(squared) ? v / std::sqrt(squared) : glm::vec3{0.0F};
}

}  // namespace

std::vector<TriangleSide> sorted_sides(std::span<const std::uint32_t> triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    sides.push_back({order_pair(triangles[i], triangles[next_corner(i)]), i});
  }
  std::ranges::sort(sides, [](const TriangleSide& a, const TriangleSide& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.number < b.number;
  });
  return sides;
}

std::vector<LinkedBorderEdge> border_edges(std::span<const glm::vec3> rest_positions,
                                           std::span<const std::uint32_t> triangles) {
  const std::vector<TriangleSide> sides = sorted_sides(triangles);
  std::vector<std::uint32_t> single;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].ends == sides[first].ends) ++end;
    if (end == first + 1) single.push_back(sides[first].number);
  }
  std::ranges::sort(single);
  std::vector<LinkedBorderEdge> border;
  border.reserve(single.size());
  for (const std::uint32_t side : single) {
    border.push_back({.ends = {triangles[side], triangles[next_corner(side)]}, .side = side});
  }
  connect(border, rest_positions);
  return border;
}

RefinedMesh::RefinedMesh(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                         int levels)
    : coarse_vertex_count_(rest_positions.size()),
      vertex_count_(rest_positions.size()),
      triangles_(triangles.begin(), triangles.end()),
      border_(border_edges(rest_positions, triangles)) {
  assert(levels >= 0 && levels <= max_levels);
  assert(triangles.empty() || *std::ranges::max_element(triangles) < rest_positions.size());
  for (int level = 0; level < levels; ++level) split();
}

void RefinedMesh::split() {
  SplitLevel& level = levels_.emplace_back();
  level.first_vertex = static_cast<std::uint32_t>(vertex_count_);
  std::vector<std::uint32_t> midpoints(triangles_.size());  // midpoint of each side of each triangle
  for (const TriangleSide& side : sorted_sides(triangles_)) {
    if (level.edges.empty() || level.edges.back() != side.ends) level.edges.push_back(side.ends);
    midpoints[side.number] = level.first_vertex + static_cast<std::uint32_t>(level.edges.size()) - 1;
  }
  split_border(midpoints, level);
  std::vector<std::uint32_t> finer;
  finer.reserve(4 * triangles_.size());
  for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
    const std::uint32_t a = triangles_[i], b = triangles_[i + 1], c = triangles_[i + 2];
    const std::uint32_t ab = midpoints[i], bc = midpoints[i + 1], ca = midpoints[i + 2];
    finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  triangles_ = std::move(finer);
  parents_.insert(parents_.end(), level.edges.begin(), level.edges.end());
  vertex_count_ += level.edges.size();
}

// Splits the border: edge e becomes 2e and 2e + 1.
void RefinedMesh::split_border(const std::vector<std::uint32_t>& midpoints, SplitLevel& level) {
  constexpr std::uint32_t none = LinkedBorderEdge::none;
  std::vector<LinkedBorderEdge> finer;
  finer.reserve(2 * border_.size());
  for (std::uint32_t e = 0; e < border_.size(); ++e) {
    const LinkedBorderEdge& edge = border_[e];
    const auto [start, end] = edge.ends;
    const std::uint32_t middle = midpoints[edge.side];
    level.curves.push_back({middle, edge.corners[0] ? start : border_[edge.previous].ends[0], start, end,
                            edge.corners[1] ? end : border_[edge.next].ends[1]});
    const std::uint32_t first_child = 4 * (edge.side / 3);
    const std::uint32_t corner = edge.side % 3;
    finer.push_back({.ends = {start, middle},
                     .side = 3 * (first_child + corner) + corner,
                     .previous = edge.previous == none ? none : 2 * edge.previous + 1,
                     .next = 2 * e + 1,
                     .corners = {edge.corners[0], false}});
    finer.push_back({.ends = {middle, end},
                     .side = 3 * (first_child + (corner + 1) % 3) + corner,
                     .previous = 2 * e,
                     .next = edge.next == none ? none : 2 * edge.next,
                     .corners = {false, edge.corners[1]}});
  }
  border_ = std::move(finer);
}

std::vector<VertexPair> RefinedMesh::refined_edges(std::span<const VertexPair> edges) const {
  std::vector<VertexPair> pairs(edges.begin(), edges.end());
  for (const SplitLevel& level : levels_) {
    std::vector<VertexPair> finer;
    finer.reserve(2 * pairs.size());
    for (const auto& [start, end] : pairs) {
      const VertexPair pair = order_pair(start, end);
      const auto found = std::ranges::lower_bound(level.edges, pair);
      if (found != level.edges.end() && *found == pair) {
        const std::uint32_t middle = level.first_vertex + static_cast<std::uint32_t>(found - level.edges.begin());
        finer.insert(finer.end(), {{start, middle}, {middle, end}});
      } else {
        finer.push_back({start, end});
      }
    }
    pairs = std::move(finer);
  }
  return pairs;
}

int refinement_levels(float edge_px, std::size_t triangles, float min_edge_px) {
  int levels = 0;
  while (levels < max_levels && edge_px > min_edge_px && 4 * triangles <= max_triangles) {
    edge_px *= 0.5F;
    triangles *= 4;
    ++levels;
  }
  return levels;
}

std::vector<VertexPair> seam_edges(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                                   std::span<const glm::vec2> corner_coordinates) {
  assert(corner_coordinates.empty() || corner_coordinates.size() == triangles.size());
  const auto normal = [&](std::uint32_t side) {
    const std::uint32_t* corners = &triangles[side - side % 3];
    const glm::vec3& a = rest_positions[corners[0]];
    return glm::cross(rest_positions[corners[1]] - a, rest_positions[corners[2]] - a);
  };
  const auto is_sharp = [&](std::uint32_t one, std::uint32_t other) {
    const glm::vec3 a = normal(one), b = normal(other);
    return glm::dot(a, b) < sharp_cosine * std::sqrt(glm::dot(a, a) * glm::dot(b, b));
  };
  const auto is_cut = [&](std::uint32_t one, std::uint32_t other) {
    const bool same_way = triangles[one] == triangles[other];
    const std::uint32_t start = same_way ? other : next_corner(other);
    const std::uint32_t end = same_way ? next_corner(other) : other;
    return differ(corner_coordinates[one], corner_coordinates[start]) ||
           differ(corner_coordinates[next_corner(one)], corner_coordinates[end]);
  };
  const std::vector<TriangleSide> sides = sorted_sides(triangles);
  std::vector<VertexPair> seams;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const std::uint32_t one = sides[i].number, other = sides[i + 1].number;
    if (sides[i].ends != sides[i + 1].ends || (!seams.empty() && seams.back() == sides[i].ends)) continue;
    if (corner_coordinates.empty() ? is_sharp(one, other) : is_cut(one, other)) seams.push_back(sides[i].ends);
  }
  return seams;
}

Rim::Rim(const RefinedMesh& mesh, float radius)
    : first_vertex_(static_cast<std::uint32_t>(mesh.vertex_count())), radius_(radius) {
  std::vector<std::uint32_t> ring_of(mesh.vertex_count(), LinkedBorderEdge::none);
  for (const LinkedBorderEdge& border : mesh.border()) {
    Edge& edge = edges_.emplace_back(Edge{border.ends, {}});
    for (std::size_t i = 0; i < 2; ++i) {
      std::uint32_t& own = ring_of[border.ends[i]];
      if (own == LinkedBorderEdge::none) {
        own = static_cast<std::uint32_t>(bases_.size());
        bases_.push_back(border.ends[i]);
        parents_.insert(parents_.end(), ring.size(), {border.ends[i], border.ends[i]});
      }
      edge.rings[i] = own;
    }
    add_triangles(edge, border.side / 3);
  }
  ways_.resize(bases_.size());
}

void Rim::add_triangles(const Edge& edge, std::uint32_t at_triangle) {
  std::array<std::uint32_t, 2> upper = edge.ends;
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    std::array<std::uint32_t, 2> lower{};
    for (std::size_t end = 0; end < 2; ++end) {
      lower[end] = first_vertex_ + static_cast<std::uint32_t>(ring.size()) * edge.rings[end] + i;
    }
    triangles_.insert(triangles_.end(), {upper[0], lower[0], lower[1], upper[0], lower[1], upper[1]});
    at_triangles_.insert(at_triangles_.end(), 2, at_triangle);
    upper = lower;
  }
}

void Rim::place(std::span<glm::vec3> positions, std::span<glm::vec3> normals, std::span<const float> slacks) {
  std::ranges::fill(ways_, glm::vec3{0.0F});
  for (const Edge& edge : edges_) {
    const glm::vec3 way = normalise(positions[edge.ends[1]] - positions[edge.ends[0]]);
    for (const std::uint32_t own : edge.rings) ways_[own] += way;
  }
  std::size_t vertex = first_vertex_;
  for (std::size_t i = 0; i < bases_.size(); ++i) {
    const glm::vec3& place = positions[bases_[i]];
    const glm::vec3& up = normals[bases_[i]];
    const glm::vec3 out = normalise(glm::cross(ways_[i], up));
    const float radius = std::min(radius_, slacks[bases_[i]] / rim_depth_radii);
    for (const RingVertex& own : ring) {
      positions[vertex] = place + radius * (own.up * up + own.out * out);
      normals[vertex] = normalise(own.facing_up * up + own.facing_out * out);
      ++vertex;
    }
  }
}

}  // namespace taut::renderer
