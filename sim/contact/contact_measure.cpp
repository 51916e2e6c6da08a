#include "sim/contact/contact_measure.hpp"

#include "sim/mesh/extent.hpp"

namespace taut::sim {
namespace {

/// A point that is less deep in a plane, sphere or capsule, in m, does not enter it.
constexpr double least_depth_m = 5e-10;
/// Each triangle around a vertex faces the same way by at least this part of the squared sum of area vectors.
constexpr double least_facing = 1e-4;

/// The other corners in turn.
Edge opposite(const Triangle& t, Index vertex) {
  const std::size_t k = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
  return {t[(k + 1) % 3], t[(k + 2) % 3]};
}

/// Orders triangles around a vertex so that each begins where the one before it ends, if they are one fan. Returns the
/// vertices around it, empty if they are not.
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

/// A thing that is further off is neither nearer than what was found nor does it touch.
double wanted_m(double reach_m, const MeasuredContact& measured) {
  return std::max(std::min(reach_m, measured.nearest_m), touching_m);
}

void note(double distance_m, bool is_crossing, double reach_m, MeasuredContact& measured) {
  measured.crossing_pairs += is_crossing ? 1 : 0;
  if (distance_m <= reach_m) measured.nearest_m = std::min(measured.nearest_m, distance_m);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Each leaves 0.62 of the axis of a capsule: all together as much of it as double precision tells apart.
constexpr int most_cuts = 40;

/// The least value of a convex function between 0 and 1, by golden sections.
template <typename Function> double least_of(const Function& f) {
  constexpr double part = 1.0 / std::numbers::phi;
  double from = 0.0, to = 1.0;
  double low = 1.0 - part, high = part;
  double at_low = f(low), at_high = f(high);
  for (int cut = 0; cut < most_cuts; ++cut) {
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
  if (least_of(from_middle) > size_m + reach_m) return infinity;
  return least_of([&](double along) { return point_triangle_distance_m(centre(along), t) - radius_m(along); });
}

struct Distance {
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
  for (const Body& body : bodies_) {
    if (const auto* mesh = std::get_if<BodyMesh>(&body.shape)) {
      body_trees_.emplace_back(mesh->data->triangles, mesh->data->positions_m);
    }
  }
  make_fans(positions_m.size());
}

void ContactMeasure::make_fans(std::size_t vertices) {
  triangles_of_ = at_vertices(vertices, triangles_);
  around_.offsets = {0};
  for (Index v = 0; v < vertices; ++v) {
    const std::span<Index> fan =
        std::span(triangles_of_.items).subspan(triangles_of_.offsets[v], triangles_of_[v].size());
    const std::vector<Index> around = order_as_fan(v, triangles_, fan);
    around_.items.insert(around_.items.end(), around.begin(), around.end());
    around_.offsets.push_back(static_cast<Index>(around_.items.size()));
  }
}

// Seen along the sum of their area vectors all triangles face the same way, and they go around the vertex once: so they
// lie beside each other, and cross nowhere.
bool ContactMeasure::lies_open(Index vertex, std::span<const Vec3> positions_m) const {
  const std::span<const Index> around = around_[vertex];
  if (around.empty()) return triangles_of_[vertex].empty();
  Vec3 sum(0.0);
  for (const Index t : triangles_of_[vertex]) sum += areas_m2_[t];
  const double least = least_facing * glm::dot(sum, sum);
  for (const Index t : triangles_of_[vertex]) {
    if (!(glm::dot(areas_m2_[t], sum) > least)) return false;
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

// Two triangles that share more vertices belong to the first of these.
std::size_t ContactMeasure::crossings_around(Index vertex, std::span<const Vec3> positions_m) const {
  const std::span<const Index> around = triangles_of_[vertex];
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
  const BodyMeshData& mesh = *std::get<BodyMesh>(body.shape).data;
  std::vector<Vec3> body_m(mesh.positions_m.size());
  positions_at(body, time_s, body_m);
  tree.fit(body_m, positions_m.front(), reach_m);
  near_.clear();
  tree_.find_near(tree, near_);
  for (const auto& [s, t] : near_) {
    const TrianglePairMeasure pair =
        measure_pair(triangles_[s], mesh.triangles[t], positions_m, body_m, wanted_m(reach_m, measured));
    note(pair.distance_m(), pair.is_crossing(), reach_m, measured);
  }
}

MeasuredContact ContactMeasure::measure(std::span<const Vec3> positions_m, double time_s, double reach_m) {
  MeasuredContact measured;
  if (triangles_.empty()) return measured;
  tree_.fit(positions_m, positions_m.front(), reach_m);
  near_.clear();
  tree_.find_near(near_);
  for (const auto& [s, t] : near_) {
    const TrianglePairMeasure pair =
        measure_pair(triangles_[s], triangles_[t], positions_m, positions_m, wanted_m(reach_m, measured));
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
      note(distance_m, distance_m < -least_depth_m, reach_m, measured);
    }
  }
  return measured;
}

double shape_distance_m(const Corners& triangle, const Shape& shape, double reach_m) {
  const double distance_m = std::visit(Distance{triangle, reach_m}, shape);
  return distance_m <= reach_m ? distance_m : infinity;
}

}  // namespace taut::sim
