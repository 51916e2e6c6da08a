#include "renderer/surface/smooth_surface.hpp"

#include "renderer/frame_view.hpp"

namespace taut::renderer {
namespace {

// Fraction of the allowed bulge that the first split may use, and each later one of the rest: a smooth curve's bulge
// falls by four from split to split.
constexpr float share_of_split = 0.75F;
// Two passes, the second in reverse: waves from vertex to vertex vanish, waves of more than four edges stay.
constexpr std::array<float, 2> fairing_passes = {0.5F, -0.53F};
// Largest motion of a border midpoint within the surface, as a fraction of its edge. Lower values leave necklines
// polygonal, higher ones turn needles around.
constexpr float max_border_shift_ratio = 0.15F;
// Largest length that is squared.
constexpr float max_squarable_length = 1e18F;

// Shortens a vector. Lost cloth may be so far away that lengths overflow; it is drawn flat.
glm::vec3 limit_length(const glm::vec3& v, float max_length) {
  const float squared = glm::dot(v, v);
  if (!std::isfinite(squared)) return glm::vec3{0.0F};
  return squared > max_length * max_length ? v * (max_length / std::sqrt(squared)) : v;
}

glm::vec3 normalise_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float squared = glm::dot(v, v);
  return squared > 1e-20F ? v / std::sqrt(squared) : otherwise;
}

// Returns the offset of the middle of the curve through four border vertices from the middle of its edge. At a corner
// the outer vertex is missing, and the curve is a parabola.
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

SmoothSurface::SmoothSurface(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                             int levels, const SurfaceFreedom& freedom, float rim_radius)
    : coarse_triangles_(triangles.begin(), triangles.end()),
      mesh_(rest_positions, triangles, levels),
      freedom_(freedom),
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
  first_parted_ = positions_.size();
  clearances_.resize(mesh_.vertex_count());
  slacks_.resize(mesh_.vertex_count());
  find_neighbours(rest_positions);
}

std::vector<glm::vec2> SmoothSurface::part_vertices(std::span<const glm::vec2> corners) {
  assert(corners.size() == triangles_.size() && first_parted_ == positions_.size());
  constexpr std::uint32_t none = ~0U;
  std::vector<glm::vec2> values(positions_.size(), glm::vec2{0.0F});
  std::vector<std::uint8_t> has_value(positions_.size(), 0);
  std::vector<std::uint32_t> others(positions_.size(), none);  // next vertex at the same position
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::uint32_t first = triangles_[i];
    std::uint32_t own = first;
    while (has_value[own] != 0 && values[own] != corners[i] && others[own] != none) own = others[own];
    if (has_value[own] != 0 && values[own] != corners[i]) {
      own = others[own] = static_cast<std::uint32_t>(values.size());
      values.emplace_back();
      has_value.push_back(0);
      others.push_back(none);
      parents_.push_back({first, first});
    }
    values[own] = corners[i];
    has_value[own] = 1;
    triangles_[i] = own;
  }
  positions_.resize(values.size());
  normals_.resize(values.size());
  return values;
}

// Border vertices have neighbours along the border only. Corners and meeting points of borders have none and stay.
void SmoothSurface::find_neighbours(std::span<const glm::vec3> rest_positions) {
  neighbour_shares_.assign(rest_positions.size(), 0.0F);
  if (mesh_.levels().empty() || !(freedom_.max_fairing > 0.0F)) return;
  const std::vector<LinkedBorderEdge> border = border_edges(rest_positions, coarse_triangles_);
  enum : std::uint8_t { inside, along, corner };
  std::vector<std::uint8_t> kinds(rest_positions.size(), inside);
  for (const LinkedBorderEdge& edge : border) {
    for (std::size_t end = 0; end < 2; ++end) {
      std::uint8_t& kind = kinds[edge.ends[end]];
      kind = std::max<std::uint8_t>(kind, edge.corners[end] ? corner : along);
    }
  }
  const auto add = [&](const VertexPair& edge, std::uint8_t kind) {
    if (kinds[edge[0]] == kind) neighbours_.push_back(edge);
    if (kinds[edge[1]] == kind) neighbours_.push_back({edge[1], edge[0]});
  };
  for (const LinkedBorderEdge& edge : border) add(edge.ends, along);
  for (const VertexPair& edge : mesh_.levels().front().edges) add(edge, inside);
  for (const VertexPair& pair : neighbours_) neighbour_shares_[pair[0]] += 1.0F;
  for (float& share : neighbour_shares_) share = share > 0.0F ? 1.0F / share : 0.0F;
}

// Moves vertices part of the way to the mean of their neighbours.
void SmoothSurface::fair(std::span<const glm::vec3> coarse_positions) {
  faired_.assign(coarse_positions.begin(), coarse_positions.end());
  for (const float share : fairing_passes) {
    means_.assign(faired_.size(), glm::vec3{0.0F});
    for (const VertexPair& pair : neighbours_) means_[pair[0]] += faired_[pair[1]] - faired_[pair[0]];
    for (std::size_t v = 0; v < faired_.size(); ++v) faired_[v] += share * neighbour_shares_[v] * means_[v];
  }
  for (std::size_t v = 0; v < faired_.size(); ++v) {
    const glm::vec3 shift =
        limit_length(faired_[v] - coarse_positions[v], std::min(freedom_.max_fairing, clearances_[v]));
    positions_[v] = coarse_positions[v] + shift;
    clearances_[v] -= glm::length(shift);
  }
}

void SmoothSurface::raise(std::span<const float> heights) {
  const std::size_t count = mesh_.vertex_count();
  raised_.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    raised_[v] = std::clamp(heights[v], -slacks_[v], slacks_[v]);
    slacks_[v] -= std::abs(raised_[v]);
  }
  // Slopes are height gradients weighted by area, so that a vertex gets their mean.
  slopes_.assign(count, glm::vec3{0.0F});
  areas_.assign(count, 0.0F);
  const std::vector<std::uint32_t>& corners = mesh_.triangles();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::uint32_t a = corners[i], b = corners[i + 1], c = corners[i + 2];
    const glm::vec3 ab = positions_[b] - positions_[a], ac = positions_[c] - positions_[a];
    const glm::vec3 normal = glm::cross(ab, ac);
    const float area = glm::length(normal);
    const glm::vec3 along = (raised_[b] - raised_[a]) * ac - (raised_[c] - raised_[a]) * ab;
    const glm::vec3 slope = area > 0.0F ? glm::cross(along, normal) / area : glm::vec3{0.0F};
    for (const std::uint32_t v : {a, b, c}) {
      slopes_[v] += slope;
      areas_[v] += area;
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    positions_[v] += raised_[v] * normals_[v];
    normals_[v] = normalise_or(areas_[v] * normals_[v] - slopes_[v], normals_[v]);
  }
}

void SmoothSurface::place(std::span<const glm::vec3> coarse_positions, std::span<const float> clearances,
                          std::span<const float> heights) {
  const std::size_t count = mesh_.coarse_vertex_count();
  assert(coarse_positions.size() == count && (clearances.empty() || clearances.size() == count));
  if (clearances.empty()) {
    std::fill_n(clearances_.begin(), count, freedom_.max_fairing + freedom_.max_bulge);
  } else {
    std::ranges::copy(clearances, clearances_.begin());
  }
  fair(coarse_positions);
  for (std::size_t v = 0; v < count; ++v) {
    clearances_[v] = std::max(clearances_[v], 0.0F);
    slacks_[v] = clearances.empty() ? std::numeric_limits<float>::infinity() : clearances_[v];
    clearances_[v] = std::min(clearances_[v], freedom_.max_bulge);
  }
  const std::span<glm::vec3> coarse = std::span(positions_).first(count);
  vertex_normals(coarse, coarse_triangles_, std::span(normals_).first(count));
  for (const RefinedMesh::SplitLevel& level : mesh_.levels()) place(level);
  if (!heights.empty()) raise(heights);
  if (rim_) rim_->place(positions_, normals_, slacks_);
  for (std::size_t v = first_parted_; v < positions_.size(); ++v) {
    const std::uint32_t first = parents_[v - count][0];
    positions_[v] = positions_[first];
    normals_[v] = normals_[first];
  }
}

void SmoothSurface::place(const RefinedMesh::SplitLevel& level) {
  std::size_t middle = level.first_vertex;
  for (const VertexPair& edge : level.edges) {
    const float room = std::min(clearances_[edge[0]], clearances_[edge[1]]);
    const float max_bulge = share_of_split * room;
    clearances_[middle] = room - max_bulge;
    const glm::vec3 way = positions_[edge[1]] - positions_[edge[0]];
    const glm::vec3& from = normals_[edge[0]];
    const glm::vec3& to = normals_[edge[1]];
    const glm::vec3 curved = (glm::dot(way, to) * to - glm::dot(way, from) * from) / 8.0F;
    const glm::vec3 bulge = limit_length(curved, max_bulge);
    positions_[middle] = 0.5F * positions_[edge[0]] + 0.5F * positions_[edge[1]] + bulge;
    slacks_[middle] = std::max(std::min(slacks_[edge[0]], slacks_[edge[1]]) - glm::length(bulge), 0.0F);
    // Normals are linear: normals that follow the curve show every unevenness of simulated cloth as a wrinkle.
    normals_[middle] = normalise_or(from + to, from);
    ++middle;
  }
  for (const RefinedMesh::BorderCurve& curve : level.curves) {
    const float max_bulge = share_of_split * std::min(clearances_[curve.start], clearances_[curve.end]);
    const float slack = std::min(slacks_[curve.start], slacks_[curve.end]);
    const glm::vec3& normal = normals_[curve.middle];
    const glm::vec3 curved = limit_length(border_shift(curve, positions_), max_squarable_length);
    const float bulge = glm::dot(curved, normal);
    const glm::vec3& start = positions_[curve.start];
    const glm::vec3& end = positions_[curve.end];
    const float max_shift = max_border_shift_ratio * std::min(glm::distance(start, end), max_squarable_length);
    const glm::vec3 shift = limit_length(
        std::clamp(bulge, -max_bulge, max_bulge) * normal + limit_length(curved - bulge * normal, max_shift), slack);
    positions_[curve.middle] = 0.5F * start + 0.5F * end + shift;
    slacks_[curve.middle] = std::max(slack - glm::length(shift), 0.0F);
  }
}

}  // namespace taut::renderer
