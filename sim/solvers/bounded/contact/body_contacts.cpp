#include "sim/solvers/bounded/contact/body_contacts.hpp"

#include "sim/contact/law.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim::bounded {
namespace {

/// Factor on a limb's size that covers the rounding of single precision; primitives further away are not near.
constexpr float size_margin_factor = 1.00001F;

/// Alternations in the search for the closest points of a triangle and a tapered limb.
constexpr int max_alternations = 8;

/// All points near a segment, at the times 0 and 1; both ends of a sphere coincide.
struct MovingLimb {
  std::array<std::array<Vec3, 2>, 2> ends_m;  ///< ends by time, relative to the origin
  std::array<double, 2> radii_m;

  /// Returns the height of a point above the limb along a direction of approximate length 1. Double precision allows
  /// limbs as large as the earth.
  double height_m(int time, const Vec3& along, const Vec3& point_m) const {
    const double length = glm::length(along);
    const auto& [start_m, end_m] = ends_m[time];
    return std::min(glm::dot(along, point_m - start_m) - length * radii_m[0],
                    glm::dot(along, point_m - end_m) - length * radii_m[1]);
  }
};

/// Closest points of a triangle and a limb, as distance from the limb's surface.
struct LimbDistance {
  glm::vec3 point = glm::vec3(0.0F);   ///< point of the triangle
  glm::vec3 normal = glm::vec3(0.0F);  ///< unit vector towards the triangle
  float distance = INFINITY;
};

/// Returns the fraction of a tapered limb's axis nearest to a point: the line to the point is at right angles to the
/// surface there.
float find_axis_fraction(const glm::vec3& start, const glm::vec3& end, const glm::vec2& radii, const glm::vec3& point) {
  const float length = glm::distance(start, end);
  const float taper = (radii.x - radii.y) / length;
  if (!(std::abs(taper) < 1.0F)) {
    return radii.x > radii.y ? 0.0F : 1.0F;  // one end ball contains the other
  }
  const glm::vec3 axis = (end - start) / length;
  const float along = glm::dot(point - start, axis);
  const float off = glm::length(point - start - along * axis);
  return std::clamp((along - off * taper / std::sqrt(1.0F - taper * taper)) / length, 0.0F, 1.0F);
}

LimbDistance limb_distance(const MovingLimb& limb, const std::array<glm::vec3, 3>& corners) {
  const glm::vec3 start(limb.ends_m[0][0]);
  const glm::vec3 end(limb.ends_m[0][1]);
  const glm::vec2 radii(limb.radii_m[0], limb.radii_m[1]);
  LimbDistance best;
  const auto consider = [&](const glm::vec3& point, float along) {
    const glm::vec3 out = point - glm::mix(start, end, along);
    const float length = glm::length(out);
    const float distance = length - glm::mix(radii.x, radii.y, along);
    if (distance < best.distance) {
      // All directions out of the axis are equally short; up is as good as any.
      best = {point, length > 0.0F ? out / length : glm::vec3(0.0F, 1.0F, 0.0F), distance};
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::vec3& a = corners[k];
    const glm::vec3& b = corners[(k + 1) % 3];
    const ClosestWeights w = closest_edges({a, b, start, end});
    consider(w[0] * a + w[1] * b, w[3]);
  }
  for (const float along : {0.0F, 1.0F}) {
    const ClosestWeights w = closest_vertex_triangle({along == 0.0F ? start : end, corners[0], corners[1], corners[2]});
    consider(w[1] * corners[0] + w[2] * corners[1] + w[3] * corners[2], along);
  }
  // Alternating minimisation: the distance is convex in both.
  for (int turn = 0; turn < max_alternations && radii.x != radii.y; ++turn) {
    const float along = find_axis_fraction(start, end, radii, best.point);
    const ClosestWeights w = closest_vertex_triangle({glm::mix(start, end, along), corners[0], corners[1], corners[2]});
    consider(w[1] * corners[0] + w[2] * corners[1] + w[3] * corners[2], along);
  }
  return best;
}

glm::vec3 from_origin(const Vec3& point_m, const Vec3& origin_m) { return {point_m - origin_m}; }

MovingLimb make_limb(const Sphere& at_begin, const Sphere& at_end, const Vec3& origin_m) {
  const Vec3 begin_m = at_begin.centre_m - origin_m;
  const Vec3 end_m = at_end.centre_m - origin_m;
  return {{{{begin_m, begin_m}, {end_m, end_m}}}, {at_begin.radius_m, at_begin.radius_m}};
}

MovingLimb make_limb(const Capsule& at_begin, const Capsule& at_end, const Vec3& origin_m) {
  return {{{{at_begin.start_m - origin_m, at_begin.end_m - origin_m},
            {at_end.start_m - origin_m, at_end.end_m - origin_m}}},
          {at_begin.start_radius_m, at_begin.end_radius_m}};
}

/// Appends an entry at `position` that moves by `move`, and returns its index.
Index add_row(const glm::vec3& position, const glm::vec3& move, RowMoves& rows) {
  rows.positions.push_back({position.x, position.y, position.z, 0.0F});
  rows.moves.push_back({move.x, move.y, move.z, 0.0F});
  rows.radii.push_back(0.0F);
  rows.inverse_masses_per_kg.push_back(0.0F);
  return static_cast<Index>(rows.radii.size() - 1);
}

/// Input of the search for one body.
struct BodySearch {
  const Body& body;
  TimeSpan time;
  Vec3 origin_m;
  float friction;
  float thickness_m;

  /// Returns the tangential motion of the surface at a point.
  glm::vec3 surface_slide(const glm::vec3& point, const glm::vec3& normal) const {
    const Vec3 at_m = Vec3(point) + origin_m;
    const glm::vec3 moved(point_moved(body, at_m, time) - at_m);
    return moved - glm::dot(moved, normal) * normal;
  }
};

void add_near_limb(const BodySearch& search, const MovingLimb& limb, std::span<const Triangle> cloth, RowMoves& rows,
                   std::vector<ContactPair>& pairs) {
  const glm::vec3 start(limb.ends_m[0][0]);
  const glm::vec3 middle = 0.5F * (start + glm::vec3(limb.ends_m[0][1]));
  const float outer = size_margin_factor *
                      (glm::distance(middle, start) + static_cast<float>(std::max(limb.radii_m[0], limb.radii_m[1])));
  for (const Triangle& t : cloth) {
    std::array<glm::vec3, 3> corners{};
    float reach = search.thickness_m;
    float approach = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = vec(rows.positions[t[k]]);
      reach = std::max(reach, search.thickness_m + rows.radii[t[k]]);
      for (std::size_t end = 0; end < 2; ++end) {
        const glm::vec3 moved(limb.ends_m[1][end] - limb.ends_m[0][end]);
        approach = std::max(approach, glm::distance(vec(rows.moves[t[k]]), moved));
      }
    }
    const float size = std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[2]));
    if (glm::distance(corners[0], middle) > outer + size + reach + approach) continue;
    const LimbDistance best = limb_distance(limb, corners);
    const Vec3 along(best.normal);
    const Vec3 point_m(best.point);
    const double height_m = limb.height_m(0, along, point_m);
    if (height_m < reach + approach) {
      const glm::vec3 below(point_m - height_m * along);
      const glm::vec3 move((height_m - limb.height_m(1, along, point_m)) * along);
      const Index row = add_row(below, move, rows);
      pairs.push_back({{{t[0], t[1], t[2], row}, 3},
                       search.thickness_m,
                       search.friction,
                       search.surface_slide(below, best.normal),
                       best.normal});
    }
  }
}

// Tests single corners: a triangle is above a plane if its corners are.
void add_near_plane(const BodySearch& search, const Plane& at_begin, const Plane& at_end,
                    std::span<const Triangle> cloth, RowMoves& rows, std::vector<ContactPair>& pairs) {
  const glm::vec3 normal(at_begin.normal);
  const Vec3 point_m = at_begin.point_m - search.origin_m;
  const Vec3 end_point_m = at_end.point_m - search.origin_m;
  const double tilt = glm::distance(at_begin.normal, at_end.normal);
  std::vector<bool> is_done(rows.radii.size(), false);
  for (const Triangle& t : cloth) {
    for (const Index v : t) {
      if (is_done[v]) continue;
      is_done[v] = true;
      // Double precision, as the plane's point may be far away.
      const Vec3 at_m = to_vec3(rows.positions[v]);
      const double max_moved_m = rows.radii[v] + vector_length(rows.moves[v]);
      const double height_m = glm::dot(at_begin.normal, at_m - point_m);
      // The plane's tilt costs a vertex this much of its height along the first normal.
      const double end_height_m = glm::dot(at_end.normal, at_m - end_point_m) - tilt * max_moved_m;
      const double reach_m = search.thickness_m + max_moved_m + std::abs(end_height_m - height_m);
      if (height_m < reach_m) {
        const glm::vec3 below(at_m - height_m * at_begin.normal);
        const Index row = add_row(below, glm::vec3((height_m - end_height_m) * at_begin.normal), rows);
        pairs.push_back({{{v, row, row, row}, 1},
                         search.thickness_m,
                         search.friction,
                         search.surface_slide(below, normal),
                         normal});
      }
    }
  }
}

}  // namespace

BodyContacts::BodyContacts(std::vector<Body> bodies, double default_friction, Index first_row)
    : bodies_(std::move(bodies)), first_row_(first_row) {
  assert(default_friction >= 0.0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    frictions_.push_back(static_cast<float>(friction_against(bodies_[b], default_friction)));
    if (const auto* mesh = std::get_if<BodyMesh>(&bodies_[b].shape)) {
      const auto first = static_cast<Index>(first_row + body_of_row_.size());
      for (const auto& [i, j, k] : mesh->data->triangles) {
        mesh_triangles_.push_back({first + i, first + j, first + k});
      }
      body_of_row_.resize(body_of_row_.size() + mesh->data->positions_m.size(), b);
    }
  }
}

std::vector<Vec3> BodyContacts::mesh_positions_m(double time_s) const {
  std::vector<Vec3> positions_m(body_of_row_.size());
  std::size_t first = 0;
  for (const Body& body : bodies_) {
    if (const auto* mesh = std::get_if<BodyMesh>(&body.shape)) {
      const std::size_t count = mesh->data->positions_m.size();
      positions_at(body, time_s, std::span(positions_m).subspan(first, count));
      first += count;
    }
  }
  return positions_m;
}

double BodyContacts::off_chord_m(const TimeSpan& time) const {
  assert(time.from_s <= time.to_s);
  double off_m = 0.0;
  for (const Body& body : bodies_) off_m = std::max(off_m, sim::off_chord_m(body, time));
  return off_m;
}

void BodyContacts::add_mesh_rows(const TimeSpan& time, const Vec3& origin_m, RowMoves& rows) const {
  assert(time.from_s <= time.to_s);
  assert(is_finite(origin_m));
  if (body_of_row_.empty()) return;
  const std::vector<Vec3> begin_m = mesh_positions_m(time.from_s);
  const std::vector<Vec3> end_m = mesh_positions_m(time.to_s);
  for (std::size_t v = 0; v < begin_m.size(); ++v) {
    add_row(from_origin(begin_m[v], origin_m), glm::vec3(end_m[v] - begin_m[v]), rows);
  }
}

void BodyContacts::add_near(std::span<const Triangle> cloth, float thickness_m, const TimeSpan& time,
                            const Vec3& origin_m, RowMoves& rows, std::vector<ContactPair>& pairs) {
  assert(thickness_m > 0.0F);
  assert(time.from_s <= time.to_s);
  near_ends_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodySearch search = {bodies_[b], time, origin_m, frictions_[b], thickness_m};
    const Shape begin = shape_at(bodies_[b], time.from_s);
    const Shape end = shape_at(bodies_[b], time.to_s);
    std::visit(
        [&](const auto& shape) {
          using Kind = std::decay_t<decltype(shape)>;
          if constexpr (std::is_same_v<Kind, Plane>) {
            add_near_plane(search, shape, std::get<Kind>(end), cloth, rows, pairs);
          } else if constexpr (!std::is_same_v<Kind, BodyMesh>) {
            add_near_limb(search, make_limb(shape, std::get<Kind>(end), origin_m), cloth, rows, pairs);
          }
        },
        begin);
    near_ends_.push_back(rows.radii.size());
  }
}

std::size_t BodyContacts::body_at_row(Index row) const {
  const std::size_t place = row - first_row_;
  if (place < body_of_row_.size()) return body_of_row_[place];
  const auto end = std::upper_bound(near_ends_.begin(), near_ends_.end(), row);
  return static_cast<std::size_t>(end - near_ends_.begin());
}

}  // namespace taut::sim::bounded
