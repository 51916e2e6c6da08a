#include "sim/solvers/bounded/blocked_pairs.hpp"

namespace taut::sim::bounded {
namespace {

using Side = std::span<const Index>;

std::array<Side, 2> split_sides(const NearPair& near) {
  const Side rows(near.rows);
  return {rows.first(near.first_count), rows.subspan(near.first_count)};
}

ContactSide describe_side(const Searched& searched, Side rows) {
  ContactSide side;
  for (const Index row : rows) {
    if (searched.bodies.has(row)) {
      side.body = searched.bodies.body_at_row(row);
    } else {
      side.vertices.push_back(searched.layout.vertex_indices[row]);
    }
  }
  std::sort(side.vertices.begin(), side.vertices.end());
  side.vertices.erase(std::unique(side.vertices.begin(), side.vertices.end()), side.vertices.end());
  return side;
}

bool is_kinematic(const Searched& searched, Side rows) {
  return std::all_of(rows.begin(), rows.end(),
                     [&](Index row) { return !(searched.rows.inverse_masses_per_kg[row] > 0.0F); });
}

bool share_free_row(const Searched& searched, Side one, Side other) {
  return std::any_of(one.begin(), one.end(), [&](Index row) {
    return searched.rows.inverse_masses_per_kg[row] > 0.0F && std::find(other.begin(), other.end(), row) != other.end();
  });
}

/// Returns the pins or the body on the far side of the blocked cloth.
std::optional<ContactSide> find_backing(const Searched& searched, const NearPair& blocked,
                                        const std::array<ContactSide, 2>& known) {
  for (const ContactPair& pair : searched.pairs) {
    const std::array<Side, 2> sides = split_sides(pair.near);
    for (std::size_t k = 0; k < 2; ++k) {
      if (is_kinematic(searched, sides[k]) && share_free_row(searched, blocked.rows, sides[1 - k])) {
        ContactSide side = describe_side(searched, sides[k]);
        if (std::find(known.begin(), known.end(), side) == known.end()) return side;
      }
    }
  }
  return std::nullopt;
}

Vec3 place_between(const Searched& searched, const NearPair& near) {
  std::array<glm::vec3, 4> p{};
  for (std::size_t k = 0; k < 4; ++k) p[k] = vec(searched.rows.positions[near.rows[k]]);
  const ClosestWeights weights = closest_weights(near, p);
  glm::vec3 place(0.0F);
  for (std::size_t k = 0; k < 4; ++k) place += 0.5F * weights[k] * p[k];
  return searched.origin_m + Vec3(place);
}

BlockedContact to_blocked_contact(const Searched& searched, const BlockedPair& pair) {
  BlockedContact blocked;
  const std::array<Side, 2> sides = split_sides(pair.near);
  blocked.sides = {describe_side(searched, sides[0]), describe_side(searched, sides[1])};
  if (is_kinematic(searched, sides[0]) != is_kinematic(searched, sides[1])) {
    blocked.behind = find_backing(searched, pair.near, blocked.sides);
  }
  blocked.place_m = place_between(searched, pair.near);
  blocked.distance_m = pair.distance;
  return blocked;
}

}  // namespace

BlockedContact blocked_contact(const Searched& searched, std::size_t row) {
  const auto index = static_cast<Index>(row);
  BlockedContact blocked;
  blocked.sides[0] = describe_side(searched, std::span(&index, 1));
  blocked.place_m = searched.origin_m + Vec3(vec(searched.rows.positions[row]));
  return blocked;
}

BlockedContact blocked_contact(const Searched& searched, const Regions& regions) {
  if (regions.blocked()) return to_blocked_contact(searched, *regions.blocked());
  std::size_t outermost = searched.layout.pin_count;
  for (std::size_t row = outermost; row < searched.layout.vertex_count(); ++row) {
    if (regions.deviation(row) > regions.deviation(outermost)) outermost = row;
  }
  return blocked_contact(searched, outermost);
}

}  // namespace taut::sim::bounded
