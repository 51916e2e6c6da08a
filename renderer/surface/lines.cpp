#include "renderer/surface/lines.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <queue>
#include <utility>

namespace taut::renderer {

namespace {

// Rows of numbers for each vertex, one after the other (compressed sparse rows).
struct Rows {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> items;

  // `fill` calls what it is handed with a vertex and an item, the same ones every time.
  template <class Fill>
  Rows(std::size_t vertex_count, const Fill& fill) : offsets(vertex_count + 1) {
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
      : edges_(edges),
        positions_(positions),
        done_(edges.size()),
        at_vertex_(positions.size(), [&](auto add) {
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
      lines_.segments.push_back(
          {{vertex, end}, chain.length, static_cast<std::uint32_t>(lines_.chains.size())});
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
  Front(const Lines& lines, std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
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

}  // namespace

Lines lines_of(std::span<const VertexPair> edges, std::span<const glm::vec3> rest_positions) {
  return ChainMaker(edges, rest_positions).made();
}

std::vector<NearestOnLine> nearest_on_lines(const Lines& lines, std::span<const glm::vec3> rest_positions,
                                            std::span<const std::uint32_t> triangles, float reach) {
  return Front(lines, rest_positions, triangles, reach).spread();
}

}  // namespace taut::renderer
