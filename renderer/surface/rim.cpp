#include "renderer/surface/rim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

// A vertex of a ring: where it is, in radii along the cloth's normal and out of the cloth, and where it
// faces.
struct RingVertex {
  float up;
  float out;
  float facing_up;
  float facing_out;
};

// Half a circle below the cloth that starts on its outside, and a slope back to its inside, which closes it.
// It ends a little before the cloth, so that it never comes out on the other side.
constexpr std::array<RingVertex, 4> ring{{{-0.5F, 0.866F, 0.5F, 0.866F},
                                          {-1.5F, 0.866F, -0.5F, 0.866F},
                                          {-2.0F, 0.0F, -1.0F, 0.0F},
                                          {-0.4F, -4.0F, -0.9F, -0.436F}}};

glm::vec3 normalised(const glm::vec3& v) {
  const float squared = glm::dot(v, v);
  return squared > 0.0F && std::isfinite(squared) ? v / std::sqrt(squared) : glm::vec3{0.0F};
}

}  // namespace

Rim::Rim(const RefinedMesh& mesh, float radius)
    : first_vertex_(static_cast<std::uint32_t>(mesh.vertex_count())), radius_(radius) {
  std::vector<std::uint32_t> ring_of(mesh.vertex_count(), BorderEdge::none);
  for (const BorderEdge& border : mesh.border()) {
    Edge& edge = edges_.emplace_back(Edge{border.ends, {}});
    for (std::size_t i = 0; i < 2; ++i) {
      std::uint32_t& own = ring_of[border.ends[i]];
      if (own == BorderEdge::none) {
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

void Rim::place(std::span<glm::vec3> positions, std::span<glm::vec3> normals) {
  std::fill(ways_.begin(), ways_.end(), glm::vec3{0.0F});
  for (const Edge& edge : edges_) {
    const glm::vec3 way = normalised(positions[edge.ends[1]] - positions[edge.ends[0]]);
    for (const std::uint32_t own : edge.rings) ways_[own] += way;
  }
  std::size_t vertex = first_vertex_;
  for (std::size_t i = 0; i < bases_.size(); ++i) {
    const glm::vec3& place = positions[bases_[i]];
    const glm::vec3& up = normals[bases_[i]];
    const glm::vec3 out = normalised(glm::cross(ways_[i], up));
    for (const RingVertex& own : ring) {
      positions[vertex] = place + radius_ * (own.up * up + own.out * out);
      normals[vertex] = normalised(own.facing_up * up + own.facing_out * out);
      ++vertex;
    }
  }
}

}  // namespace taut::renderer
