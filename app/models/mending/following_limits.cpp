#include "app/models/mending/following_limits.hpp"

#include "app/garments/fitting/tuning.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

using sim::Index;
using sim::Vec3;

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

/// Returns the vector from the triangle to the edge at the point where they cross.
Vec3 find_way(const sim::Edge& edge, const sim::Triangle& t, const sim::Piercing& at, std::span<const Vec3> points_m) {
  return glm::mix(points_m[edge[0]], points_m[edge[1]], at.along) - at.weights.x * points_m[t[0]] -
         at.weights.y * points_m[t[1]] - at.weights.z * points_m[t[2]];
}

}  // namespace

ShapeLimits::ShapeLimits(const sim::Mesh& model_m, double max_stretch, std::span<const Index> rigid_parts)
    : model_(sim::make_garment(model_m, {.flexural_rule = sim::FlexuralRule::none})),
      tree_(model_m.triangles, model_m.positions),
      triangles_at_(sim::at_vertices(model_m.positions.size(), model_m.triangles)),
      max_ratio_(1.0 + max_stretch),
      edge_m_(mean_edge_m(model_m)),
      is_rigid_(model_m.positions.size(), 0) {
  for (std::size_t v = 0; v < rigid_parts.size(); ++v) is_rigid_[v] = rigid_parts[v] != sim::no_vertex ? 1 : 0;
  for (const sim::CrossingPair& pair : sim::find_crossing_pairs({model_m.positions, model_m.triangles}, tree_)) {
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

double ShapeLimits::find_side(const sim::Piercing& piercing, const Vec3& front, std::span<const Vec3> feet_m) const {
  const sim::Edge& edge = model_.adjacency.edges[piercing.edge];
  const sim::Triangle& triangle = model_.mesh.triangles[piercing.triangle];
  const std::vector<Vec3>& rest_m = model_.mesh.positions;
  const Vec3 apart_m = find_way(edge, triangle, piercing, rest_m);
  const double side_m = glm::dot(apart_m, sim::unit_or_zero(sim::doubled_area_vector(rest_m, triangle)));
  const double distance_m = glm::length(apart_m);
  return distance_m <= max_wall_edges * edge_m_ && std::abs(side_m) >= min_wall_cosine * distance_m
             ? side_m
             : glm::dot(find_way(edge, triangle, piercing, feet_m), front);
}

void ShapeLimits::part(std::span<const sim::CrossingPair> crossings, std::span<const Vec3> feet_m,
                       std::vector<Vec3>& points_m) const {
  std::vector<sim::TrianglePair> pairs;
  for (const sim::CrossingPair& pair : crossings) pairs.push_back({pair.first, pair.second});
  std::vector<Vec3> sums_m(points_m.size(), Vec3(0.0));
  std::vector<double> weights(points_m.size(), 0.0);
  const auto ask = [&](Index v, const Vec3& move_m, double weight) {
    sums_m[v] += weight * move_m;
    weights[v] += weight;
  };
  for (const sim::Piercing& p : sim::find_piercings(model_, pairs, points_m)) {
    const auto& [first, second] = model_.adjacency.edges[p.edge];
    const Vec3 front = p.first_is_in_front ? p.normal : -p.normal;
    const double side = find_side(p, front, feet_m);
    const bool first_is_wrong = p.first_is_in_front != (side > 0.0);
    const double height_m = std::abs(glm::dot(p.normal, points_m[second] - points_m[first]));
    const double depth_m = height_m * (first_is_wrong ? p.along : 1.0 - p.along);
    const double way_m = std::min(depth_m + parting_margin_edges * edge_m_, edge_m_);
    const Vec3 half_m = std::copysign(0.5 * way_m, side) * front;
    ask(first_is_wrong ? first : second, half_m, 1.0);
    for (int k = 0; k < 3; ++k) ask(model_.mesh.triangles[p.triangle][k], -half_m, p.weights[k]);
  }
  for (Index v = 0; v < points_m.size(); ++v) {
    if (weights[v] > 0.0 && is_rigid_[v] == 0) points_m[v] += sums_m[v] / weights[v];
  }
}

void ShapeLimits::smooth(std::span<const sim::CrossingPair> crossings, std::vector<Vec3>& points_m) const {
  std::set<Index> vertices;
  for (const sim::CrossingPair& pair : crossings) {
    for (const Index t : {pair.first, pair.second}) {
      for (const Index v : model_.mesh.triangles[t]) {
        if (is_rigid_[v] == 0) vertices.insert(v);
      }
    }
  }
  const std::vector<Vec3> before_m = points_m;
  for (const Index v : vertices) {
    const auto edges = model_.adjacency.vertex_edges[v];
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

void ShapeLimits::update_crossings(std::span<const Vec3> before_m, std::span<const Vec3> points_m,
                                   std::vector<sim::CrossingPair>& pairs) const {
  std::vector<std::uint8_t> is_moved;
  for (const sim::Triangle& t : model_.mesh.triangles) {
    is_moved.push_back(before_m.empty() || std::ranges::any_of(t, [&](Index v) { return points_m[v] != before_m[v]; }));
  }
  std::erase_if(pairs, [&](const auto& pair) { return is_moved[pair.first] != 0 || is_moved[pair.second] != 0; });
  const auto found = sim::find_crossing_pairs({points_m, model_.mesh.triangles}, tree_, is_moved);
  pairs.insert(pairs.end(), found.begin(), found.end());
  std::ranges::sort(pairs, {}, [](const auto& pair) { return std::pair(pair.first, pair.second); });
}

void ShapeLimits::apply(std::span<const Vec3> feet_m, std::vector<Vec3>& points_m) const {
  shorten(points_m);
  const std::size_t triangles = model_.mesh.triangles.size();
  if (static_cast<double>(own_crossings_.size()) > max_own_crossing_fraction * static_cast<double>(triangles)) return;
  std::size_t work = 0;
  std::vector<Vec3> before_m;
  std::vector<sim::CrossingPair> all;
  std::vector<Vec3> best_m;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (int round = 0;; ++round) {
    update_crossings(before_m, points_m, all);
    before_m = points_m;
    std::vector<sim::CrossingPair> crossings = all;
    work += triangles + work_of_crossing * crossings.size();
    erase_own(crossings);
    if (crossings.size() < fewest) {
      fewest = crossings.size();
      best_m = points_m;
    }
    if (crossings.empty() || round == max_parting_rounds || work > max_parting_work) break;
    part(crossings, feet_m, points_m);
    smooth(crossings, points_m);
    shorten(points_m);
  }
  points_m = std::move(best_m);
}

sim::Stretch ShapeLimits::measure_stretch(std::span<const Vec3> points_m) const {
  return sim::measure_stretch(model_.springs, points_m);
}

FollowingMeasures ShapeLimits::measure(std::span<const Vec3> points_m) const {
  std::vector<sim::CrossingPair> crossings = sim::find_crossing_pairs({points_m, model_.mesh.triangles}, tree_);
  const std::size_t all = crossings.size();
  erase_own(crossings);
  return {measure_stretch(points_m), sim::measure_surface_stretch(model_, points_m).p99, all, crossings.size()};
}

}  // namespace taut::app
