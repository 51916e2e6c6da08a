#include "sim/contact/contact_measure.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Smallest depth in m of a point that enters a plane, sphere or capsule.
constexpr double min_depth_m = 5e-10;
/// Smallest product of a triangle's area vector with the sum around its vertex, as a fraction of the squared sum, for a
/// fan that lies open.
constexpr double min_facing_ratio = 1e-4;

/// Returns the two other corners in ring order.
Edge opposite(const Triangle& t, Index vertex) {
  const std::size_t k = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
  return {t[(k + 1) % 3], t[(k + 2) % 3]};
}

/// Orders the triangles of a fan around a vertex so that each begins where the previous one ends. Returns the ring of
/// neighbours; empty if they form no fan.
std::vector<Index> order_as_fan(Index vertex, std::span<const Triangle> triangles, std::span<Index> fan) {
  const auto begins = [&](Index t) { return opposite(triangles[t], vertex)[0]; };
  const auto ends = [&](Index t) { return opposite(triangles[t], vertex)[1]; };
  for (std::size_t k = 0; k < fan.size(); ++k) {
    if (std::none_of(fan.begin(), fan.end(), [&](Index t) { return ends(t) == begins(fan[k]); })) {
      std::swap(fan[0], fan[k]);
      break;
    }
  }
  std::vector<Index> around;
  for (std::size_t k = 0; k < fan.size(); ++k) {
    const auto next = std::find_if(fan.begin() + static_cast<std::ptrdiff_t>(k), fan.end(),
                                   [&](Index t) { return k == 0 || begins(t) == around.back(); });
    if (next == fan.end()) return {};
    std::swap(fan[k], *next);
    if (k == 0) around.push_back(begins(fan[0]));
    around.push_back(ends(fan[k]));
  }
  return around;
}

/// Returns the distance beyond which a pair neither lowers the minimum nor touches.
double search_reach_m(double reach_m, const MeasuredContact& measured) {
  return std::max(std::min(reach_m, measured.min_distance_m), touching_m);
}

void note(double distance_m, bool is_crossing, double reach_m, MeasuredContact& measured) {
  measured.crossing_pairs += is_crossing ? 1 : 0;
  if (distance_m <= reach_m) measured.min_distance_m = std::min(measured.min_distance_m, distance_m);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Number of golden sections. Each leaves 0.62 of a capsule's axis; together they reach the resolution of double
/// precision.
constexpr int section_count = 40;

/// Returns the minimum of a convex function on [0, 1], by golden sections.
template <typename Function> double convex_minimum(const Function& f) {
  constexpr double part = 1.0 / std::numbers::phi;
  double from = 0.0, to = 1.0;
  double low = 1.0 - part, high = part;
  double at_low = f(low), at_high = f(high);
  for (int cut = 0; cut < section_count; ++cut) {
    if (at_low < at_high) {
      to = high;
      high = low;
      at_high = at_low;
      low = to - part * (to - from);
      at_low = f(low);
    } else {
      from = low;
      low = high;
      at_low = at_high;
      high = from + part * (to - from);
      at_high = f(high);
    }
  }
  return std::min({f(0.0), at_low, at_high, f(1.0)});
}

double limb_distance_m(const Corners& t, const Capsule& limb, double reach_m) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const double size_m =
      std::max({glm::distance(middle, t[0]), glm::distance(middle, t[1]), glm::distance(middle, t[2])});
  const auto centre = [&](double along) { return glm::mix(limb.start_m, limb.end_m, along); };
  const auto radius_m = [&](double along) { return glm::mix(limb.start_radius_m, limb.end_radius_m, along); };
  const double outer_m =
      0.5 * glm::distance(limb.start_m, limb.end_m) + std::max(limb.start_radius_m, limb.end_radius_m);
  if (glm::distance(centre(0.5), middle) > outer_m + size_m + reach_m) return infinity;
  const auto from_middle = [&](double along) { return glm::distance(centre(along), middle) - radius_m(along); };
  if (convex_minimum(from_middle) > size_m + reach_m) return infinity;
  return convex_minimum([&](double along) { return point_triangle_distance_m(centre(along), t) - radius_m(along); });
}

struct TriangleDistance {
  const Corners& t;
  double reach_m;

  double operator()(const Plane& plane) const {
    const auto height_m = [&](const Vec3& corner) { return glm::dot(corner - plane.point_m, plane.normal); };
    return std::min({height_m(t[0]), height_m(t[1]), height_m(t[2])});
  }
  double operator()(const Sphere& ball) const { return point_triangle_distance_m(ball.centre_m, t) - ball.radius_m; }
  double operator()(const Capsule& limb) const { return limb_distance_m(t, limb, reach_m); }
  double operator()(const BodyMesh&) const { return infinity; }
};

}  // namespace

ContactMeasure::ContactMeasure(std::span<const Triangle> triangles, std::span<const Vec3> positions_m,
                               std::vector<Body> bodies)
    : triangles_(triangles.begin(), triangles.end()),
      bodies_(std::move(bodies)),
      tree_(triangles, positions_m),
      areas_m2_(triangles.size()) {
  assert(are_below(triangles, positions_m.size()));
  for (const Body& body : bodies_) {
    if (const auto* mesh = std::get_if<BodyMesh>(&body.shape)) {
      body_trees_.emplace_back(mesh->data->triangles, mesh->data->positions_m);
    }
  }
  make_fans(positions_m.size());
}

void ContactMeasure::make_fans(std::size_t vertices) {
  vertex_triangles_ = at_vertices(vertices, triangles_);
  ring_vertices_.offsets = {0};
  for (Index v = 0; v < vertices; ++v) {
    const std::span<Index> fan =
        std::span(vertex_triangles_.items).subspan(vertex_triangles_.offsets[v], vertex_triangles_[v].size());
    const std::vector<Index> around = order_as_fan(v, triangles_, fan);
    ring_vertices_.items.insert(ring_vertices_.items.end(), around.begin(), around.end());
    ring_vertices_.offsets.push_back(static_cast<Index>(ring_vertices_.items.size()));
  }
}

// All triangles face along the sum of their area vectors and surround the vertex once, so none of them cross.
bool ContactMeasure::lies_open(Index vertex, std::span<const Vec3> positions_m) const {
  assert(vertex < positions_m.size());
  const std::span<const Index> around = ring_vertices_[vertex];
  if (around.empty()) return vertex_triangles_[vertex].empty();
  Vec3 sum(0.0);
  for (const Index t : vertex_triangles_[vertex]) sum += areas_m2_[t];
  const double min_facing = min_facing_ratio * glm::dot(sum, sum);
  for (const Index t : vertex_triangles_[vertex]) {
    if (!(glm::dot(areas_m2_[t], sum) > min_facing)) return false;
  }
  const Vec3& here = positions_m[vertex];
  const Vec3 ahead = glm::cross(sum, positions_m[around[0]] - here);
  bool is_past_half = false;
  const std::size_t closes = around.front() == around.back() ? 1 : 0;
  for (const Index v : around.subspan(1, around.size() - 1 - closes)) {
    const bool is_ahead = glm::dot(ahead, positions_m[v] - here) > 0.0;
    if (is_past_half && is_ahead) return false;
    is_past_half = !is_ahead;
  }
  return true;
}

// Triangles that share several vertices are counted at the lowest one.
std::size_t ContactMeasure::crossings_around(Index vertex, std::span<const Vec3> positions_m) const {
  assert(vertex < positions_m.size());
  const std::span<const Index> around = vertex_triangles_[vertex];
  std::size_t crossings = 0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    for (std::size_t l = k + 1; l < around.size(); ++l) {
      const Triangle& s = triangles_[around[k]];
      const Triangle& t = triangles_[around[l]];
      const bool is_of_lower = std::any_of(
          s.begin(), s.end(), [&](Index v) { return v < vertex && std::find(t.begin(), t.end(), v) != t.end(); });
      if (!is_of_lower && neighbours_cross(s, t, positions_m)) ++crossings;
    }
  }
  return crossings;
}

void ContactMeasure::measure_mesh(const Body& body, TriangleTree& tree, std::span<const Vec3> positions_m,
                                  double time_s, double reach_m, MeasuredContact& measured) {
  assert(reach_m >= 0.0);
  assert(std::isfinite(time_s));
  const BodyMeshData& mesh = *std::get<BodyMesh>(body.shape).data;
  std::vector<Vec3> body_m(mesh.positions_m.size());
  positions_at(body, time_s, body_m);
  tree.fit(body_m, positions_m.front(), reach_m);
  near_.clear();
  tree_.find_near(tree, near_);
  for (const auto& [s, t] : near_) {
    const TrianglePairMeasure pair =
        measure_pair(triangles_[s], mesh.triangles[t], positions_m, body_m, search_reach_m(reach_m, measured));
    note(pair.distance_m(), pair.is_crossing(), reach_m, measured);
  }
}

MeasuredContact ContactMeasure::measure(std::span<const Vec3> positions_m, double time_s, double reach_m) {
  assert(reach_m >= 0.0);
  assert(std::isfinite(time_s));
  MeasuredContact measured;
  if (triangles_.empty()) return measured;
  tree_.fit(positions_m, positions_m.front(), reach_m);
  near_.clear();
  tree_.find_near(near_);
  for (const auto& [s, t] : near_) {
    const TrianglePairMeasure pair =
        measure_pair(triangles_[s], triangles_[t], positions_m, positions_m, search_reach_m(reach_m, measured));
    note(pair.distance_m(), pair.is_crossing(), reach_m, measured);
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& [i, j, k] = triangles_[t];
    areas_m2_[t] = glm::cross(positions_m[j] - positions_m[i], positions_m[k] - positions_m[i]);
  }
  for (Index v = 0; v < positions_m.size(); ++v) {
    measured.crossing_pairs += lies_open(v, positions_m) ? 0 : crossings_around(v, positions_m);
  }
  auto tree = body_trees_.begin();
  for (const Body& body : bodies_) {
    if (std::holds_alternative<BodyMesh>(body.shape)) {
      measure_mesh(body, *tree++, positions_m, time_s, reach_m, measured);
      continue;
    }
    const Shape shape = shape_at(body, time_s);
    for (const auto& [i, j, k] : triangles_) {
      const double distance_m = shape_distance_m({positions_m[i], positions_m[j], positions_m[k]}, shape, reach_m);
      note(distance_m, distance_m < -min_depth_m, reach_m, measured);
    }
  }
  return measured;
}

bool enters(const Corners& triangle, const Shape& shape) {
  return shape_distance_m(triangle, shape, 0.0) < -min_depth_m;
}

double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m) {
  assert(reach_m >= 0.0);
  const double distance_m = std::visit(TriangleDistance{triangle, reach_m}, shape);
  return distance_m <= reach_m ? distance_m : infinity;
}

}  // namespace taut::sim
