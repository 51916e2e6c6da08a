#include "sim/solvers/bounded/contact/crossings.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "sim/mesh/extent.hpp"

namespace taut::sim::bounded {
namespace {

bool has_row(const Triangle& t, Index row) {
  return t[0] == row || t[1] == row || t[2] == row;
}

/// Whether `d` is above the plane of the triangle a, b, c.
bool is_above(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a) > 0.0;
}

/// Whether an edge of the one triangle goes through the other.
bool pierces(const Triangle& edges_of, const Triangle& t, std::span<const Vec3> p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index i = edges_of[k];
    const Index j = edges_of[(k + 1) % 3];
    if (has_row(t, i) || has_row(t, j) ||
        is_above(p[t[0]], p[t[1]], p[t[2]], p[i]) == is_above(p[t[0]], p[t[1]], p[t[2]], p[j])) {
      continue;
    }
    const bool side = is_above(p[i], p[j], p[t[0]], p[t[1]]);
    if (side == is_above(p[i], p[j], p[t[1]], p[t[2]]) && side == is_above(p[i], p[j], p[t[2]], p[t[0]])) {
      return true;
    }
  }
  return false;
}

bool cross(const Triangle& s, const Triangle& t, std::span<const Vec3> positions) {
  return pierces(s, t, positions) || pierces(t, s, positions);
}

/// Calls each(s, t) for every two triangles whose extents overlap.
template <typename Each>
void for_overlapping(std::span<const Triangle> triangles, std::span<const Vec3> positions, const Each& each) {
  std::vector<Extent> extents;
  Extent all;
  for (const Triangle& t : triangles) {
    const std::array<Vec3, 3> corners = {positions[t[0]], positions[t[1]], positions[t[2]]};
    extents.push_back(extent_of(corners));
    all.add(extents.back().lower);
    all.add(extents.back().upper);
  }
  const int axis = longest_axis(all);
  std::vector<Index> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](Index s, Index t) { return extents[s].lower[axis] < extents[t].lower[axis]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Extent& one = extents[order[i]];
    for (std::size_t j = i + 1; j < order.size() && extents[order[j]].lower[axis] <= one.upper[axis]; ++j) {
      if (overlap(one, extents[order[j]])) {
        each(order[i], order[j]);
      }
    }
  }
}

Edge ordered(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Crossings::Crossings(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
                     std::span<const Vec3> positions_m) {
  if (!within_cloth && bodies.empty()) {
    return;
  }
  std::vector<Triangle> triangles(cloth.begin(), cloth.end());
  triangles.insert(triangles.end(), bodies.begin(), bodies.end());
  for_overlapping(triangles, positions_m, [&](Index s, Index t) {
    const auto& [low, high] = std::minmax(s, t);
    const bool is_wanted = low < cloth.size() && (within_cloth || high >= cloth.size());
    if (is_wanted && cross(triangles[s], triangles[t], positions_m)) {
      pairs_.push_back({triangles[s], triangles[t]});
    }
  });
  find_keys();
}

void Crossings::update(std::span<const Vec3> positions_m) {
  if (std::erase_if(pairs_, [&](const auto& pair) { return !cross(pair[0], pair[1], positions_m); }) > 0) {
    find_keys();
  }
}

Crossings::Key Crossings::key_of(const NearPair& near) {
  const auto& r = near.rows;
  if (near.first_count == 1) {
    Triangle t = {r[1], r[2], r[3]};
    std::sort(t.begin(), t.end());
    return {1, r[0], t[0], t[1], t[2]};
  }
  const Edge first = ordered(r[0], r[1]);
  const Edge second = ordered(r[2], r[3]);
  const auto& [low, high] = std::minmax(first, second);
  return {2, low[0], low[1], high[0], high[1]};
}

void Crossings::find_keys() {
  keys_.clear();
  for (const auto& [s, t] : pairs_) {
    for (std::size_t k = 0; k < 3; ++k) {
      keys_.push_back(key_of({{s[k], t[0], t[1], t[2]}, 1}));
      keys_.push_back(key_of({{t[k], s[0], s[1], s[2]}, 1}));
      for (std::size_t l = 0; l < 3; ++l) {
        keys_.push_back(key_of({{s[k], s[(k + 1) % 3], t[l], t[(l + 1) % 3]}, 2}));
      }
    }
  }
  std::sort(keys_.begin(), keys_.end());
}

bool Crossings::has(const NearPair& near) const {
  return !keys_.empty() && std::binary_search(keys_.begin(), keys_.end(), key_of(near));
}

}  // namespace taut::sim::bounded
