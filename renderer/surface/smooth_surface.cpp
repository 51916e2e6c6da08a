#include "renderer/surface/smooth_surface.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/mesh_normals.hpp"

namespace taut::renderer {

namespace {

// Share of the allowed bulge that the first split may use, and of what is left that each later one may: a
// smooth curve's bulge falls by four from split to split.
constexpr float share_of_split = 0.75F;
// How far a midpoint of a border may move within the surface, share of its edge. Less leaves necklines
// polygons, more turns needles around.
constexpr float most_border_shift = 0.15F;
// Beyond this lengths are not squared any more.
constexpr float farthest = 1e18F;

// Cloth that is lost may be so far away that lengths overflow: it is drawn flat.
glm::vec3 shortened(const glm::vec3& v, float longest) {
  const float squared = glm::dot(v, v);
  if (!std::isfinite(squared)) return glm::vec3{0.0F};
  return squared > longest * longest ? v * (longest / std::sqrt(squared)) : v;
}

glm::vec3 normalised(const glm::vec3& v, const glm::vec3& otherwise) {
  const float squared = glm::dot(v, v);
  return squared > 1e-20F ? v / std::sqrt(squared) : otherwise;
}

// Where the curve through four border vertices is in its middle, from the middle of its edge. Beyond a
// corner there is none, and the curve is a parabola.
glm::vec3 border_shift(const RefinedMesh::BorderCurve& curve, std::span<const glm::vec3> places) {
  const bool starts = curve.before == curve.start;
  const bool ends = curve.after == curve.end;
  const glm::vec3 way = places[curve.end] - places[curve.start];
  const glm::vec3 before = places[curve.start] - places[curve.before];
  const glm::vec3 after = places[curve.after] - places[curve.end];
  if (starts && ends) return glm::vec3{0.0F};
  if (starts) return (way - after) / 8.0F;
  if (ends) return (before - way) / 8.0F;
  return (before - after) / 16.0F;
}

}  // namespace

SmoothSurface::SmoothSurface(std::span<const glm::vec3> rest_positions,
                             std::span<const std::uint32_t> triangles, int levels, float most_bulge,
                             float rim_radius)
    : coarse_triangles_(triangles.begin(), triangles.end()),
      mesh_(rest_positions, triangles, levels),
      most_bulge_(most_bulge),
      triangles_(mesh_.triangles()),
      parents_(mesh_.parents()) {
  for (std::size_t t = 0; t < triangles_.size() / 3; ++t) {
    parent_triangles_.push_back(static_cast<std::uint32_t>(t >> (2 * levels)));
  }
  if (rim_radius > 0.0F) {
    rim_.emplace(mesh_, rim_radius);
    triangles_.insert(triangles_.end(), rim_->triangles().begin(), rim_->triangles().end());
    parents_.insert(parents_.end(), rim_->parents().begin(), rim_->parents().end());
    for (const std::uint32_t at : rim_->at_triangles()) parent_triangles_.push_back(parent_triangles_[at]);
  }
  positions_.resize(mesh_.coarse_vertex_count() + parents_.size());
  normals_.resize(positions_.size());
}

void SmoothSurface::place(std::span<const glm::vec3> coarse_positions) {
  const std::size_t count = mesh_.coarse_vertex_count();
  assert(coarse_positions.size() == count);
  std::copy(coarse_positions.begin(), coarse_positions.end(), positions_.begin());
  vertex_normals(coarse_positions, coarse_triangles_, std::span(normals_).first(count));
  float left = most_bulge_;
  for (const RefinedMesh::Level& level : mesh_.levels()) {
    place(level, share_of_split * left);
    left -= share_of_split * left;
  }
  if (rim_) rim_->place(positions_, normals_);
}

void SmoothSurface::place(const RefinedMesh::Level& level, float most_bulge) {
  std::size_t middle = level.first_vertex;
  for (const VertexPair& edge : level.edges) {
    const glm::vec3 way = positions_[edge[1]] - positions_[edge[0]];
    const glm::vec3& from = normals_[edge[0]];
    const glm::vec3& to = normals_[edge[1]];
    const glm::vec3 bulge = (glm::dot(way, to) * to - glm::dot(way, from) * from) / 8.0F;
    positions_[middle] =
        0.5F * positions_[edge[0]] + 0.5F * positions_[edge[1]] + shortened(bulge, most_bulge);
    // Linear, because normals that follow the curve show every unevenness of simulated cloth as a wrinkle.
    normals_[middle] = normalised(from + to, from);
    ++middle;
  }
  for (const RefinedMesh::BorderCurve& curve : level.curves) {
    const glm::vec3& normal = normals_[curve.middle];
    const glm::vec3 shift = shortened(border_shift(curve, positions_), farthest);
    const float bulge = glm::dot(shift, normal);
    const glm::vec3& start = positions_[curve.start];
    const glm::vec3& end = positions_[curve.end];
    positions_[curve.middle] =
        0.5F * start + 0.5F * end + std::clamp(bulge, -most_bulge, most_bulge) * normal +
        shortened(shift - bulge * normal, most_border_shift * std::min(glm::distance(start, end), farthest));
  }
}

}  // namespace taut::renderer
