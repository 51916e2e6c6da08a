#include "app/models/mending/following_limits.hpp"

#include "app/garments/fitting/tuning.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {

using namespace fitting;

namespace {

using sim::Index;
using sim::Vec3;

std::vector<float> compute_reaches(std::span<const Bond> bonds, const sim::Mesh& simulated, float max_distance_m) {
  std::vector<float> reach_m(simulated.positions.size(), 0.0F);
  for (const Bond& bond : bonds) {
    const float offset_m = std::min(static_cast<float>(glm::length(bond.offset_m)), max_distance_m);
    for (const Index v : simulated.triangles[bond.triangle]) reach_m[v] = std::max(reach_m[v], offset_m);
  }
  return reach_m;
}

/// Moves the corners of a triangle by the least that shortens its most stretched direction to this ratio. Returns
/// whether the triangle was longer.
bool shorten_triangle(const sim::TriangleAtRest& rest, const sim::Triangle& t, double max_ratio,
                      std::vector<Vec3>& points_m) {
  const sim::DeformationGradient gradient = sim::deformation_gradient(rest, sim::corner_positions(t, points_m));
  const double ratio = sim::principal_stretches(gradient).max_ratio;
  if (!(ratio > max_ratio + stretch_tolerance)) return false;
  const sim::Vec2 direction = sim::principal_direction(gradient);
  const Vec3 stretched = direction.x * gradient.along + direction.y * gradient.across;
  std::array<double, 3> by_corner{};
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    by_corner[k] = glm::dot(sim::gradients_by_corners(rest)[k], direction);
    squared += by_corner[k] * by_corner[k];
  }
  const double step = over_correction * (max_ratio - ratio) / (squared * ratio);
  for (std::size_t k = 0; k < 3; ++k) points_m[t[k]] += step * by_corner[k] * stretched;
  return true;
}

}  // namespace

OffsetLimits::OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated)
    : max_reach_m_(static_cast<float>(max_reach_edges * mean_edge_m(simulated))),
      reach_m_(compute_reaches(bonds, simulated, max_reach_m_)),
      clearances_(simulated.triangles, {}, true, simulated.positions) {
  const std::span<const float> shares = clearances_.find_ratios(simulated.positions, reach_m_);
  at_rest_.assign(shares.begin(), shares.end());
  std::replace_if(
      at_rest_.begin(), at_rest_.end(), [](float share) { return share < min_share_at_rest; }, 1.0F);
}

std::vector<float> OffsetLimits::shares(std::span<const Bond> bonds, std::span<const Vec3> positions_m,
                                        std::span<const sim::Triangle> triangles) const {
  const std::lock_guard lock(mutex_);
  const std::span<const float> clearance_shares = clearances_.find_ratios(positions_m, reach_m_);
  const auto at_vertex = [&](Index v) { return std::min(clearance_shares[v] / at_rest_[v], 1.0F); };
  std::vector<float> shares;
  shares.reserve(bonds.size());
  for (const Bond& bond : bonds) {
    const auto& [a, b, c] = triangles[bond.triangle];
    const auto& [u, v, w] = bond.weights;
    const double share = u * at_vertex(a) + v * at_vertex(b) + w * at_vertex(c);
    // A larger offset loses no more of its length than the largest that is looked for.
    const double limited = max_reach_m_ / std::max(glm::length(bond.offset_m), double{max_reach_m_});
    shares.push_back(static_cast<float>(1.0 - limited * (1.0 - share)));
  }
  return shares;
}

ShapeLimits::ShapeLimits(const sim::Mesh& model_m, double max_stretch, const CarriedVertices& carried)
    : model_(sim::make_garment(model_m, {.flexural_rule = sim::FlexuralRule::none})),
      tree_(model_m.triangles, model_m.positions),
      triangles_at_(sim::at_vertices(model_m.positions.size(), model_m.triangles)),
      max_ratio_(1.0 + max_stretch),
      is_rigid_(model_m.positions.size(), 0) {
  for (std::size_t k = 0; k < carried.vertices.size(); ++k) {
    is_rigid_[carried.vertices[k]] = carried.is_rigid[k];
  }
  for (const sim::CrossingPair& pair : find_crossings(model_m.positions)) {
    own_crossings_.push_back({pair.first, pair.second});
  }
}

void ShapeLimits::shorten(std::vector<Vec3>& points_m) const {
  const std::vector<sim::Triangle>& triangles = model_.mesh.triangles;
  std::vector<std::uint8_t> is_due(triangles.size(), 1);
  bool is_moved = true;
  for (int sweep = 0; is_moved && sweep < max_sweeps; ++sweep) {
    is_moved = false;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const sim::TriangleAtRest& rest = model_.triangles_at_rest[t];
      if (is_due[t] == 0 || !rest.has_surface()) continue;
      is_due[t] = 0;
      if (!shorten_triangle(rest, triangles[t], max_ratio_, points_m)) continue;
      is_moved = true;
      for (const Index v : triangles[t]) {
        for (const Index neighbour : triangles_at_[v]) is_due[neighbour] = 1;
      }
    }
  }
}

void ShapeLimits::smooth(std::span<const std::uint8_t> is_marked, std::vector<Vec3>& points_m) const {
  const std::vector<Vec3> before_m = points_m;
  for (Index v = 0; v < points_m.size(); ++v) {
    const auto edges = model_.adjacency.vertex_edges[v];
    if (is_marked[v] == 0 || is_rigid_[v] != 0 || edges.empty()) continue;
    Vec3 sum_m(0.0);
    for (const Index e : edges) sum_m += before_m[sim::other_end(model_.adjacency.edges[e], v)];
    points_m[v] += smoothing_weight * (sum_m / static_cast<double>(edges.size()) - before_m[v]);
  }
}

void ShapeLimits::erase_own(std::vector<sim::CrossingPair>& pairs) const {
  std::erase_if(pairs, [&](const sim::CrossingPair& pair) {
    return std::binary_search(own_crossings_.begin(), own_crossings_.end(), std::array{pair.first, pair.second});
  });
}

std::vector<sim::CrossingPair> ShapeLimits::find_crossings(std::span<const Vec3> points_m) const {
  return sim::find_crossing_pairs({points_m, model_.mesh.triangles}, tree_);
}

void ShapeLimits::apply(std::vector<Vec3>& points_m) const {
  shorten(points_m);
  const auto max_crossings =
      static_cast<std::size_t>(max_crossing_fraction * static_cast<double>(model_.mesh.triangles.size()));
  if (own_crossings_.size() > max_crossings) return;
  for (int round = 0; round < max_smoothing_rounds; ++round) {
    std::vector<sim::CrossingPair> crossings = find_crossings(points_m);
    erase_own(crossings);
    if (crossings.empty() || crossings.size() > max_crossings) return;
    std::vector<std::uint8_t> is_marked(points_m.size(), 0);
    for (const sim::CrossingPair& pair : crossings) {
      for (const Index t : {pair.first, pair.second}) {
        for (const Index v : model_.mesh.triangles[t]) is_marked[v] = 1;
      }
    }
    smooth(is_marked, points_m);
    shorten(points_m);
  }
}

FollowingMeasures ShapeLimits::measure(std::span<const Vec3> points_m) const {
  std::vector<sim::CrossingPair> crossings = find_crossings(points_m);
  const std::size_t all = crossings.size();
  erase_own(crossings);
  return {sim::measure_stretch(model_.springs, points_m), sim::measure_surface_stretch(model_, points_m).p99, all,
          crossings.size()};
}

}  // namespace taut::app
