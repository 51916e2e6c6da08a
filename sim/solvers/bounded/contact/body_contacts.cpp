#include "sim/solvers/bounded/contact/body_contacts.hpp"

#include "sim/contact/law.hpp"

namespace taut::sim::bounded {
namespace {

/// A thing that single precision puts further from a limb than this many times the limb's size is not near.
constexpr float far_enough = 1.00001F;

/// How often the nearest points of a triangle and a tapered limb are looked for from each other.
constexpr int most_turns = 8;

/// All points near a segment, at the times 0 and 1; a sphere's ends are in one place.
struct Limb {
  std::array<std::array<Vec3, 2>, 2> ends_m;  ///< by time, from the origin
  std::array<double, 2> radii_m;

  /// Returns how far a point is above the limb along a direction, whose length need not be 1 to the last bit.
  /// In double precision: limbs may be as large as the earth.
  double height_m(int time, const Vec3& along, const Vec3& point_m) const {
    const double length = glm::length(along);
    const auto& [start_m, end_m] = ends_m[time];
    return std::min(glm::dot(along, point_m - start_m) - length * radii_m[0],
                    glm::dot(along, point_m - end_m) - length * radii_m[1]);
  }
};

/// Where a triangle and the axis of a limb are nearest, less the limb's radius there.
struct Nearest {
  glm::vec3 point = glm::vec3(0.0F);   ///< of the triangle
  glm::vec3 normal = glm::vec3(0.0F);  ///< towards the triangle
  float distance = INFINITY;
};

/// Returns which part of the way along its axis a tapered limb is nearest to a point: where the line to the
/// point is at right angles to its surface.
float nearest_along(const glm::vec3& start, const glm::vec3& end, const glm::vec2& radii, const glm::vec3& point) {
  const float length = glm::distance(start, end);
  const float taper = (radii.x - radii.y) / length;
  if (!(std::abs(taper) < 1.0F)) {
    return radii.x > radii.y ? 0.0F : 1.0F;  // the one ball is within the other
  }
  const glm::vec3 axis = (end - start) / length;
  const float along = glm::dot(point - start, axis);
  const float off = glm::length(point - start - along * axis);
  return std::clamp((along - off * taper / std::sqrt(1.0F - taper * taper)) / length, 0.0F, 1.0F);
}

Nearest nearest_of(const Limb& limb, const std::array<glm::vec3, 3>& corners) {
  const glm::vec3 start(limb.ends_m[0][0]);
  const glm::vec3 end(limb.ends_m[0][1]);
  const glm::vec2 radii(limb.radii_m[0], limb.radii_m[1]);
  Nearest nearest;
  const auto consider = [&](const glm::vec3& point, float along) {
    const glm::vec3 out = point - glm::mix(start, end, along);
    const float length = glm::length(out);
    const float distance = length - glm::mix(radii.x, radii.y, along);
    if (distance < nearest.distance) {
      // On the axis every way out is equally short; up is as good as any.
      nearest = {point, length > 0.0F ? out / length : glm::vec3(0.0F, 1.0F, 0.0F), distance};
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
  // In turns: the distance is convex in both.
  for (int turn = 0; turn < most_turns && radii.x != radii.y; ++turn) {
    const float along = nearest_along(start, end, radii, nearest.point);
    const ClosestWeights w = closest_vertex_triangle({glm::mix(start, end, along), corners[0], corners[1], corners[2]});
    consider(w[1] * corners[0] + w[2] * corners[1] + w[3] * corners[2], along);
  }
  return nearest;
}

glm::vec3 from_origin(const Vec3& point_m, const Vec3& origin_m) { return {point_m - origin_m}; }

Limb limb_of(const Sphere& at_begin, const Sphere& at_end, const Vec3& origin_m) {
  const Vec3 begin_m = at_begin.centre_m - origin_m;
  const Vec3 end_m = at_end.centre_m - origin_m;
  return {{{{begin_m, begin_m}, {end_m, end_m}}}, {at_begin.radius_m, at_begin.radius_m}};
}

Limb limb_of(const Capsule& at_begin, const Capsule& at_end, const Vec3& origin_m) {
  return {{{{at_begin.start_m - origin_m, at_begin.end_m - origin_m},
            {at_end.start_m - origin_m, at_end.end_m - origin_m}}},
          {at_begin.start_radius_m, at_begin.end_radius_m}};
}

/// Appends a row at `position` that moves by `move`, and returns it.
Index add_row(const glm::vec3& position, const glm::vec3& move, RowMoves& rows) {
  rows.positions.push_back({position.x, position.y, position.z, 0.0F});
  rows.moves.push_back({move.x, move.y, move.z, 0.0F});
  rows.radii.push_back(0.0F);
  rows.inverse_masses_per_kg.push_back(0.0F);
  return static_cast<Index>(rows.radii.size() - 1);
}

/// One body in one search.
struct Search {
  const Body& body;
  TimeSpan time;
  Vec3 origin_m;
  float friction;
  float thickness_m;

  /// How the surface at a point slides along itself.
  glm::vec3 slides(const glm::vec3& point, const glm::vec3& normal) const {
    const Vec3 at_m = Vec3(point) + origin_m;
    const glm::vec3 moved(point_moved(body, at_m, time) - at_m);
    return moved - glm::dot(moved, normal) * normal;
  }
};

void add_near_limb(const Search& search, const Limb& limb, std::span<const Triangle> cloth, RowMoves& rows,
                   std::vector<ContactPair>& pairs) {
  const glm::vec3 start(limb.ends_m[0][0]);
  const glm::vec3 middle = 0.5F * (start + glm::vec3(limb.ends_m[0][1]));
  const float outer =
      far_enough * (glm::distance(middle, start) + static_cast<float>(std::max(limb.radii_m[0], limb.radii_m[1])));
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
    const Nearest nearest = nearest_of(limb, corners);
    const Vec3 along(nearest.normal);
    const Vec3 point_m(nearest.point);
    const double height_m = limb.height_m(0, along, point_m);
    if (height_m < reach + approach) {
      const glm::vec3 below(point_m - height_m * along);
      const glm::vec3 move((height_m - limb.height_m(1, along, point_m)) * along);
      const Index row = add_row(below, move, rows);
      pairs.push_back({{{t[0], t[1], t[2], row}, 3},
                       search.thickness_m,
                       search.friction,
                       search.slides(below, nearest.normal),
                       nearest.normal});
    }
  }
}

// Corner by corner: a triangle is above a plane if its corners are.
void add_near_plane(const Search& search, const Plane& at_begin, const Plane& at_end, std::span<const Triangle> cloth,
                    RowMoves& rows, std::vector<ContactPair>& pairs) {
  const glm::vec3 normal(at_begin.normal);
  const Vec3 point_m = at_begin.point_m - search.origin_m;
  const Vec3 end_point_m = at_end.point_m - search.origin_m;
  const double tilt = glm::distance(at_begin.normal, at_end.normal);
  std::vector<bool> is_done(rows.radii.size(), false);
  for (const Triangle& t : cloth) {
    for (const Index v : t) {
      if (is_done[v]) continue;
      is_done[v] = true;
      // In double precision: the plane's point may be far away.
      const Vec3 at_m = vector_of(rows.positions[v]);
      const double most_moved_m = rows.radii[v] + length_of(rows.moves[v]);
      const double height_m = glm::dot(at_begin.normal, at_m - point_m);
      // Over a plane that has tilted a vertex loses so much of what it keeps along the first normal.
      const double end_height_m = glm::dot(at_end.normal, at_m - end_point_m) - tilt * most_moved_m;
      const double reach_m = search.thickness_m + most_moved_m + std::abs(end_height_m - height_m);
      if (height_m < reach_m) {
        const glm::vec3 below(at_m - height_m * at_begin.normal);
        const Index row = add_row(below, glm::vec3((height_m - end_height_m) * at_begin.normal), rows);
        pairs.push_back(
            {{{v, row, row, row}, 1}, search.thickness_m, search.friction, search.slides(below, normal), normal});
      }
    }
  }
}

}  // namespace

BodyContacts::BodyContacts(std::vector<Body> bodies, double default_friction, Index first_row)
    : bodies_(std::move(bodies)), first_row_(first_row) {
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
  double off_m = 0.0;
  for (const Body& body : bodies_) off_m = std::max(off_m, sim::off_chord_m(body, time));
  return off_m;
}

void BodyContacts::add_mesh_rows(const TimeSpan& time, const Vec3& origin_m, RowMoves& rows) const {
  if (body_of_row_.empty()) return;
  const std::vector<Vec3> begin_m = mesh_positions_m(time.from_s);
  const std::vector<Vec3> end_m = mesh_positions_m(time.to_s);
  for (std::size_t v = 0; v < begin_m.size(); ++v) {
    add_row(from_origin(begin_m[v], origin_m), glm::vec3(end_m[v] - begin_m[v]), rows);
  }
}

void BodyContacts::add_near(std::span<const Triangle> cloth, float thickness_m, const TimeSpan& time,
                            const Vec3& origin_m, RowMoves& rows, std::vector<ContactPair>& pairs) {
  near_ends_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Search search = {bodies_[b], time, origin_m, frictions_[b], thickness_m};
    const Shape begin = shape_at(bodies_[b], time.from_s);
    const Shape end = shape_at(bodies_[b], time.to_s);
    std::visit(
        [&](const auto& shape) {
          using Kind = std::decay_t<decltype(shape)>;
          if constexpr (std::is_same_v<Kind, Plane>) {
            add_near_plane(search, shape, std::get<Kind>(end), cloth, rows, pairs);
          } else if constexpr (!std::is_same_v<Kind, BodyMesh>) {
            add_near_limb(search, limb_of(shape, std::get<Kind>(end), origin_m), cloth, rows, pairs);
          }
        },
        begin);
    near_ends_.push_back(rows.radii.size());
  }
}

std::size_t BodyContacts::body_of(Index row) const {
  const std::size_t place = row - first_row_;
  if (place < body_of_row_.size()) return body_of_row_[place];
  const auto end = std::upper_bound(near_ends_.begin(), near_ends_.end(), row);
  return static_cast<std::size_t>(end - near_ends_.begin());
}

}  // namespace taut::sim::bounded
