#include "sim/solvers/bounded/contact/body_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <type_traits>

#include "sim/solvers/bounded/contact/closest_points.hpp"

namespace taut::sim::bounded {
namespace {

/// All points near a segment, at the times 0 and 1; a sphere's ends are in one place.
struct Limb {
  std::array<std::array<glm::vec3, 2>, 2> ends;  ///< by time, from the origin
  std::array<float, 2> radii;

  /// Returns how far the limb reaches along a direction.
  float reach(int time, const glm::vec3& along) const {
    const auto& [start, end] = ends[time];
    return std::max(glm::dot(along, start) + radii[0], glm::dot(along, end) + radii[1]);
  }
};

/// Where a triangle and the axis of a limb are nearest, less the limb's radius there.
struct Nearest {
  glm::vec3 point = glm::vec3(0.0F);   ///< of the triangle
  glm::vec3 normal = glm::vec3(0.0F);  ///< towards the triangle
  float distance = INFINITY;
};

Nearest nearest_of(const Limb& limb, const std::array<glm::vec3, 3>& corners) {
  const glm::vec3& start = limb.ends[0][0];
  const glm::vec3& end = limb.ends[0][1];
  Nearest nearest;
  const auto consider = [&](const glm::vec3& point, float along) {
    const glm::vec3 out = point - glm::mix(start, end, along);
    const float length = glm::length(out);
    const float distance = length - glm::mix(limb.radii[0], limb.radii[1], along);
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
    const ClosestWeights w =
        closest_vertex_triangle({along == 0.0F ? start : end, corners[0], corners[1], corners[2]});
    consider(w[1] * corners[0] + w[2] * corners[1] + w[3] * corners[2], along);
  }
  return nearest;
}

glm::vec3 from_origin(const Vec3& point_m, const Vec3& origin_m) {
  return {point_m - origin_m};
}

Limb limb_of(const Sphere& at_begin, const Sphere& at_end, const Vec3& origin_m) {
  const glm::vec3 begin = from_origin(at_begin.centre_m, origin_m);
  const glm::vec3 end = from_origin(at_end.centre_m, origin_m);
  const auto radius = static_cast<float>(at_begin.radius_m);
  return {{{{begin, begin}, {end, end}}}, {radius, radius}};
}

Limb limb_of(const Capsule& at_begin, const Capsule& at_end, const Vec3& origin_m) {
  return {{{{from_origin(at_begin.start_m, origin_m), from_origin(at_begin.end_m, origin_m)},
            {from_origin(at_end.start_m, origin_m), from_origin(at_end.end_m, origin_m)}}},
          {static_cast<float>(at_begin.start_radius_m), static_cast<float>(at_begin.end_radius_m)}};
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
  const glm::vec3 middle = 0.5F * (limb.ends[0][0] + limb.ends[0][1]);
  const float outer = glm::distance(middle, limb.ends[0][0]) + std::max(limb.radii[0], limb.radii[1]);
  for (const Triangle& t : cloth) {
    std::array<glm::vec3, 3> corners{};
    float reach = search.thickness_m;
    float approach = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = vec(rows.positions[t[k]]);
      reach = std::max(reach, search.thickness_m + rows.radii[t[k]]);
      for (std::size_t end = 0; end < 2; ++end) {
        const glm::vec3 moved = limb.ends[1][end] - limb.ends[0][end];
        approach = std::max(approach, glm::distance(vec(rows.moves[t[k]]), moved));
      }
    }
    const float size = std::max(glm::distance(corners[0], corners[1]), glm::distance(corners[0], corners[2]));
    if (glm::distance(corners[0], middle) > outer + size + reach + approach) {
      continue;
    }
    const Nearest nearest = nearest_of(limb, corners);
    const float begin = limb.reach(0, nearest.normal);
    if (glm::dot(nearest.normal, nearest.point) - begin < reach + approach) {
      const glm::vec3 below =
          nearest.point + nearest.normal * (begin - glm::dot(nearest.normal, nearest.point));
      const glm::vec3 move = nearest.normal * (limb.reach(1, nearest.normal) - begin);
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
void add_near_plane(const Search& search, const Plane& at_begin, const Plane& at_end,
                    std::span<const Triangle> cloth, RowMoves& rows, std::vector<ContactPair>& pairs) {
  const glm::vec3 normal(at_begin.normal);
  const glm::vec3 end_normal(at_end.normal);
  const glm::vec3 point = from_origin(at_begin.point_m, search.origin_m);
  const glm::vec3 end_point = from_origin(at_end.point_m, search.origin_m);
  std::vector<bool> is_done(rows.radii.size(), false);
  for (const Triangle& t : cloth) {
    for (const Index v : t) {
      if (is_done[v]) {
        continue;
      }
      is_done[v] = true;
      const glm::vec3 at = vec(rows.positions[v]);
      const float height = glm::dot(normal, at - point);
      const float end_height = glm::dot(end_normal, at - end_point);
      const float reach = search.thickness_m + rows.radii[v] + glm::length(vec(rows.moves[v])) +
                          std::abs(end_height - height);
      if (height < reach) {
        const glm::vec3 below = at - height * normal;
        const Index row = add_row(below, normal * (height - end_height), rows);
        pairs.push_back({{{v, row, row, row}, 1},
                         search.thickness_m,
                         search.friction,
                         search.slides(below, normal),
                         normal});
      }
    }
  }
}

}  // namespace

BodyContacts::BodyContacts(std::vector<Body> bodies, double default_friction, Index first_row)
    : bodies_(std::move(bodies)), first_row_(first_row) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    frictions_.push_back(static_cast<float>(bodies_[b].friction.value_or(default_friction)));
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
  for (const Body& body : bodies_) {
    off_m = std::max(off_m, sim::off_chord_m(body, time));
  }
  return off_m;
}

void BodyContacts::add_mesh_rows(const TimeSpan& time, const Vec3& origin_m, RowMoves& rows) const {
  if (body_of_row_.empty()) {
    return;
  }
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
  if (place < body_of_row_.size()) {
    return body_of_row_[place];
  }
  const auto end = std::upper_bound(near_ends_.begin(), near_ends_.end(), row);
  return static_cast<std::size_t>(end - near_ends_.begin());
}

}  // namespace taut::sim::bounded
