#include "sim/solvers/bounded/contact/crossings.hpp"

#include "sim/contact/triangle_tree.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim::bounded {
namespace {

/// Rings of triangles around a contour.
constexpr int rings = 2;
/// Smallest distance in m that single precision resolves.
constexpr double min_resolved_m = 0.5 * min_rest_distance_m;

CompressedRows group_triangles_by_row(std::span<const Triangle> triangles) {
  Index rows = 0;
  for (const Triangle& t : triangles) rows = std::max({rows, t[0] + 1, t[1] + 1, t[2] + 1});
  return at_vertices(rows, triangles);
}

bool has_row(const Triangle& t, Index row) { return t[0] == row || t[1] == row || t[2] == row; }

}  // namespace

Crossings::Crossings(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
                     std::vector<Vec3> rest_m)
    : within_cloth_(within_cloth),
      cloth_count_(cloth.size()),
      triangles_(cloth.begin(), cloth.end()),
      rest_m_(std::move(rest_m)) {
  assert(are_below(cloth, rest_m_.size()));
  triangles_.insert(triangles_.end(), bodies.begin(), bodies.end());
  row_triangles_ = group_triangles_by_row(triangles_);
  triangle_groups_.assign(triangles_.size(), 0);
  if (within_cloth_) find_touching_at_rest();
}

TrianglePairMeasure Crossings::measure(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const {
  assert(s < triangles_.size());
  assert(t < triangles_.size());
  return are_neighbours ? measure_neighbours(triangles_[s], triangles_[t], positions_m)
                        : measure_pair(triangles_[s], triangles_[t], positions_m, positions_m);
}

// Nearly all neighbours do, which saves measuring them.
bool Crossings::lie_apart(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const {
  return are_neighbours && corner_neighbours_lie_apart(triangles_[s], triangles_[t], positions_m, min_rest_distance_m);
}

bool Crossings::is_kept_apart(Index s, Index t, bool are_neighbours) const {
  return std::max(s, t) >= cloth_count_ || lie_apart(s, t, are_neighbours, rest_m_) ||
         measure(s, t, are_neighbours, rest_m_).parts_m >= min_rest_distance_m;
}

void Crossings::find_touching_at_rest() {
  std::vector<Index> cloth(cloth_count_);
  std::iota(cloth.begin(), cloth.end(), 0U);
  for_pairs(cloth, rest_m_, min_rest_distance_m, [&](Index s, Index t, bool are_neighbours) {
    if (is_kept_apart(s, t, are_neighbours)) return;
    is_touching_at_rest_.resize(cloth_count_, false);
    is_touching_at_rest_[s] = is_touching_at_rest_[t] = true;
  });
}

// Primitives near at rest, as in the finest meshes, count as apart, as contact leaves them out anyway. Touching ones do
// not, so that their group stays.
bool Crossings::is_apart(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const {
  if (lie_apart(s, t, are_neighbours, positions_m)) return true;
  if (are_neighbours && neighbours_cross(triangles_[s], triangles_[t], positions_m)) return false;
  const TrianglePairMeasure now = measure(s, t, are_neighbours, positions_m);
  if (now.is_pierced || (!are_neighbours && now.is_crossing())) return false;
  return now.parts_m > min_resolved_m || !is_kept_apart(s, t, are_neighbours);
}

/// Calls each(s, t, are_neighbours) for all pairs among these triangles that may touch. `among` is ascending.
template <typename Each>
void Crossings::for_pairs(std::span<const Index> among, std::span<const Vec3> positions_m, double reach_m,
                          const Each& each) const {
  assert(reach_m >= 0.0);
  std::vector<Triangle> triangles;
  std::vector<bool> is_among(triangles_.size(), false);
  for (const Index t : among) {
    triangles.push_back(triangles_[t]);
    is_among[t] = true;
  }
  const auto is_wanted = [&](Index s, Index t) {
    return std::min(s, t) < cloth_count_ && (within_cloth_ || std::max(s, t) >= cloth_count_);
  };
  TriangleTree tree(triangles, positions_m);
  tree.fit(positions_m, positions_m.front(), reach_m);
  std::vector<TriangleCouple> near;
  tree.find_near(near);
  for (const auto& [i, j] : near) {
    if (is_wanted(among[i], among[j])) each(among[i], among[j], false);
  }
  for (const Index s : among) {
    for (std::size_t k = 0; k < 3 && within_cloth_ && s < cloth_count_; ++k) {
      for (const Index t : row_triangles_[triangles_[s][k]]) {
        // Triangles that share several vertices come once, at the first.
        const bool has_come =
            (k > 0 && has_row(triangles_[t], triangles_[s][0])) || (k > 1 && has_row(triangles_[t], triangles_[s][1]));
        if (t > s && is_among[t] && !has_come) each(s, t, true);
      }
    }
  }
}

void Crossings::add(std::span<const Vec3> positions_m) {
  if (!within_cloth_ && cloth_count_ == triangles_.size()) return;
  std::vector<Index> all(triangles_.size());
  std::iota(all.begin(), all.end(), 0U);
  Groups groups(triangles_.size());
  std::vector<Index> seeds;
  for_pairs(all, positions_m, min_resolved_m, [&](Index s, Index t, bool are_neighbours) {
    if (!is_apart(s, t, are_neighbours, positions_m)) {
      groups.join(s, t);
      seeds.insert(seeds.end(), {s, t});
    }
  });
  for (Index t = 0; t < triangle_groups_.size(); ++t) {
    if (triangle_groups_[t] > 0) groups.join(t, triangle_groups_[t] - 1);
  }
  std::vector<bool> is_in(triangles_.size(), false);
  for (const Index t : seeds) is_in[t] = true;
  std::vector<Index> patch = seeds;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<Index> before = patch;
    for (const Index s : before) {
      for (const Index row : triangles_[s]) {
        for (const Index t : row_triangles_[row]) {
          groups.join(s, t);
          if (!is_in[t]) {
            is_in[t] = true;
            patch.push_back(t);
          }
        }
      }
    }
  }
  for (Index t = 0; t < triangle_groups_.size(); ++t) {
    triangle_groups_[t] = is_in[t] || triangle_groups_[t] > 0 ? groups.find(t) + 1 : 0;
  }
  find_keys();
}

void Crossings::free(std::span<const Vec3> positions_m) {
  std::vector<Index> patches;
  std::vector<bool> stays(triangles_.size() + 1, false);
  for (Index t = 0; t < triangle_groups_.size(); ++t) {
    if (triangle_groups_[t] > 0) patches.push_back(t);
  }
  if (patches.empty()) return;
  for_pairs(patches, positions_m, min_resolved_m, [&](Index s, Index t, bool are_neighbours) {
    const Index group = triangle_groups_[s];
    if (group == triangle_groups_[t] && !stays[group] && !is_apart(s, t, are_neighbours, positions_m)) {
      stays[group] = true;
    }
  });
  const auto is_free = [&](Index group) { return group > 0 && !stays[group]; };
  if (std::any_of(triangle_groups_.begin(), triangle_groups_.end(), is_free)) {
    std::replace_if(triangle_groups_.begin(), triangle_groups_.end(), is_free, 0U);
    find_keys();
  }
}

// A primitive is in a group if all of its triangles are.
void Crossings::find_keys() {
  keys_.clear();
  const auto lies_in = [&](std::span<const Index> rows, Index group) {
    const std::span<const Index> of = row_triangles_[rows.front()];
    return std::all_of(of.begin(), of.end(), [&](Index t) {
      const bool is_of = std::all_of(rows.begin(), rows.end(), [&](Index row) { return has_row(triangles_[t], row); });
      return !is_of || triangle_groups_[t] == group;
    });
  };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (triangle_groups_[t] == 0) continue;
    Triangle rows = triangles_[t];
    std::sort(rows.begin(), rows.end());
    const auto [a, b, c] = rows;
    for (const Triangle& thing :
         {Triangle{a, a, a}, {b, b, b}, {c, c, c}, {a, b, b}, {a, c, c}, {b, c, c}, {a, b, c}}) {
      if (lies_in(thing, triangle_groups_[t])) keys_.push_back({thing, triangle_groups_[t]});
    }
  }
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
}

Index Crossings::find_group(std::span<const Index> rows) const {
  Triangle sorted = {rows.front(), rows.back(), rows[rows.size() / 2]};
  if (rows.size() == 2) {
    sorted = {std::min(rows[0], rows[1]), std::max(rows[0], rows[1]), std::max(rows[0], rows[1])};
  } else {
    std::sort(sorted.begin(), sorted.end());
  }
  const auto key = std::lower_bound(keys_.begin(), keys_.end(), Key{sorted, 0});
  return key != keys_.end() && key->rows == sorted ? key->group : 0;
}

bool Crossings::has(const NearPair& near) const {
  if (keys_.empty()) return false;
  const Index first = find_group(std::span(near.rows).first(near.first_count));
  return first > 0 && first == find_group(std::span(near.rows).subspan(near.first_count));
}

void Crossings::set_groups(std::vector<Index> find_group) {
  if (find_group != triangle_groups_) {
    triangle_groups_ = std::move(find_group);
    find_keys();
  }
}

}  // namespace taut::sim::bounded
