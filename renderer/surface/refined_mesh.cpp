#include "renderer/surface/refined_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

// Cosine of the turn of a border at rest from which it has a corner.
constexpr float corner_cosine = 0.7071F;
// More triangles than this are not made: their pictures would take longer than they are worth.
constexpr std::size_t most_triangles = 400'000;
constexpr int most_levels = 4;

VertexPair sorted(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// The only edge that starts (end 0) or ends (end 1) at each vertex.
std::vector<std::uint32_t> only_edges(const std::vector<BorderEdge>& border, std::size_t end,
                                      std::size_t vertex_count) {
  std::vector<std::uint32_t> found(vertex_count, BorderEdge::none);
  std::vector<std::uint8_t> counts(vertex_count, 0);
  for (std::uint32_t e = 0; e < border.size(); ++e) {
    const std::uint32_t vertex = border[e].ends[end];
    found[vertex] = counts[vertex] == 0 ? e : BorderEdge::none;
    counts[vertex] = 1;
  }
  return found;
}

void connect(std::vector<BorderEdge>& border, std::span<const glm::vec3> rest_positions) {
  const std::vector<std::uint32_t> starting = only_edges(border, 0, rest_positions.size());
  const std::vector<std::uint32_t> ending = only_edges(border, 1, rest_positions.size());
  const auto way = [&](const BorderEdge& edge) {
    return rest_positions[edge.ends[1]] - rest_positions[edge.ends[0]];
  };
  for (std::uint32_t e = 0; e < border.size(); ++e) {
    const std::uint32_t vertex = border[e].ends[1];
    const std::uint32_t after = starting[vertex];
    if (after == BorderEdge::none || ending[vertex] == BorderEdge::none) continue;
    border[e].next = after;
    border[after].previous = e;
  }
  for (BorderEdge& edge : border) {
    const auto turns = [&](std::uint32_t other) {
      if (other == BorderEdge::none) return true;
      const glm::vec3 own = way(edge);
      const glm::vec3 its = way(border[other]);
      return glm::dot(own, its) < corner_cosine * std::sqrt(glm::dot(own, own) * glm::dot(its, its));
    };
    edge.corners = {turns(edge.previous), turns(edge.next)};
  }
}

}  // namespace

std::vector<TriangleSide> sorted_sides(std::span<const std::uint32_t> triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    sides.push_back({sorted(triangles[i], triangles[next_corner(i)]), i});
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.number < b.number;
  });
  return sides;
}

std::vector<BorderEdge> border_edges(std::span<const glm::vec3> rest_positions,
                                     std::span<const std::uint32_t> triangles) {
  const std::vector<TriangleSide> sides = sorted_sides(triangles);
  std::vector<std::uint32_t> single;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].ends == sides[first].ends) ++end;
    if (end == first + 1) single.push_back(sides[first].number);
  }
  std::sort(single.begin(), single.end());
  std::vector<BorderEdge> border;
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
  assert(levels >= 0 && levels <= most_levels);
  assert(triangles.empty() || *std::max_element(triangles.begin(), triangles.end()) < rest_positions.size());
  for (int level = 0; level < levels; ++level) split();
}

void RefinedMesh::split() {
  Level& level = levels_.emplace_back();
  level.first_vertex = static_cast<std::uint32_t>(vertex_count_);
  std::vector<std::uint32_t> midpoints(triangles_.size());  // of each side of each triangle
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

// Edge e becomes 2e and 2e + 1.
void RefinedMesh::split_border(const std::vector<std::uint32_t>& midpoints, Level& level) {
  constexpr std::uint32_t none = BorderEdge::none;
  std::vector<BorderEdge> finer;
  finer.reserve(2 * border_.size());
  for (std::uint32_t e = 0; e < border_.size(); ++e) {
    const BorderEdge& edge = border_[e];
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

std::vector<std::uint32_t> RefinedMesh::refined_edges(std::span<const std::uint32_t> edges) const {
  std::vector<std::uint32_t> pairs(edges.begin(), edges.end());
  for (const Level& level : levels_) {
    std::vector<std::uint32_t> finer;
    finer.reserve(2 * pairs.size());
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
      const VertexPair pair = sorted(pairs[i], pairs[i + 1]);
      const auto found = std::lower_bound(level.edges.begin(), level.edges.end(), pair);
      if (found != level.edges.end() && *found == pair) {
        const std::uint32_t middle =
            level.first_vertex + static_cast<std::uint32_t>(found - level.edges.begin());
        finer.insert(finer.end(), {pairs[i], middle, middle, pairs[i + 1]});
      } else {
        finer.insert(finer.end(), {pairs[i], pairs[i + 1]});
      }
    }
    pairs = std::move(finer);
  }
  return pairs;
}

int refinement_levels(float edge_px, std::size_t triangles, float shortest_px) {
  int levels = 0;
  while (levels < most_levels && edge_px > shortest_px && 4 * triangles <= most_triangles) {
    edge_px *= 0.5F;
    triangles *= 4;
    ++levels;
  }
  return levels;
}

}  // namespace taut::renderer
