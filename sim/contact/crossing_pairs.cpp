#include "sim/contact/crossing_pairs.hpp"

#include "sim/contact/triangle_pair.hpp"
#include "sim/mesh/adjacency.hpp"

namespace taut::sim {
namespace {

bool is_over(const Vec3& point_m, const Corners& t, const Vec3& normal) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (glm::dot(glm::cross(t[(k + 1) % 3] - t[k], point_m - t[k]), normal) < 0.0) return false;
  }
  return true;
}

/// Returns the first point where an edge of `a` passes through `b`; empty if none does.
std::optional<Vec3> pierced_point(const Corners& a, const Corners& b) {
  const Vec3 normal = glm::cross(b[1] - b[0], b[2] - b[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &from = a[k], &to = a[(k + 1) % 3];
    const double before = glm::dot(from - b[0], normal), behind = glm::dot(to - b[0], normal);
    if (!(before * behind < 0.0)) continue;
    const Vec3 point_m = glm::mix(from, to, before / (before - behind));
    if (is_over(point_m, b, normal)) return point_m;
  }
  return std::nullopt;
}

/// Returns a point where one triangle pierces the other, or the middle of both if they only touch.
Vec3 crossing_place(const Corners& a, const Corners& b) {
  if (const std::optional<Vec3> point_m = pierced_point(a, b)) return *point_m;
  return pierced_point(b, a).value_or((a[0] + a[1] + a[2] + b[0] + b[1] + b[2]) / 6.0);
}

std::vector<CrossingPair> to_sorted_pairs(std::vector<TriangleCouple> crossing, const Surface& cloth,
                                          const Surface& other) {
  std::sort(crossing.begin(), crossing.end());
  std::vector<CrossingPair> pairs;
  for (const auto& [s, t] : crossing) {
    pairs.push_back({s, t,
                     crossing_place(corner_positions(cloth.triangles[s], cloth.positions_m),
                                    corner_positions(other.triangles[t], other.positions_m))});
  }
  return pairs;
}

/// Erases the pairs that do not cross.
void erase_apart(const Surface& cloth, const Surface& other, std::vector<TriangleCouple>& pairs) {
  std::erase_if(pairs, [&](const TriangleCouple& pair) {
    return !measure_pair(cloth.triangles[pair[0]], other.triangles[pair[1]], cloth.positions_m, other.positions_m,
                         touching_m)
                .is_crossing();
  });
}

bool is_lowest_shared(Index vertex, const Triangle& s, const Triangle& t) {
  return std::none_of(s.begin(), s.end(),
                      [&](Index v) { return v < vertex && std::find(t.begin(), t.end(), v) != t.end(); });
}

void add_crossing_neighbours(const Surface& cloth, std::span<const std::uint8_t> is_marked,
                             std::vector<TriangleCouple>& crossing) {
  const CompressedRows vertex_triangles = at_vertices(cloth.positions_m.size(), cloth.triangles);
  for (Index v = 0; v < cloth.positions_m.size(); ++v) {
    const std::span<const Index> around = vertex_triangles[v];
    for (std::size_t k = 0; k < around.size(); ++k) {
      for (const Index other : around.subspan(k + 1)) {
        if (is_marked[around[k]] == 0 && is_marked[other] == 0) continue;
        const Triangle &s = cloth.triangles[around[k]], &t = cloth.triangles[other];
        if (is_lowest_shared(v, s, t) && neighbours_cross(s, t, cloth.positions_m)) {
          crossing.push_back({std::min(around[k], other), std::max(around[k], other)});
        }
      }
    }
  }
}

}  // namespace

std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth) {
  return find_crossing_pairs(cloth, TriangleTree(cloth.triangles, cloth.positions_m));
}

std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, TriangleTree tree) {
  return find_crossing_pairs(cloth, std::move(tree), std::vector<std::uint8_t>(cloth.triangles.size(), 1));
}

std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, TriangleTree tree,
                                              std::span<const std::uint8_t> is_marked) {
  if (cloth.triangles.empty()) return {};
  tree.fit(cloth.positions_m, cloth.positions_m.front(), 0.0);
  tree.search_marked(is_marked);
  std::vector<TriangleCouple> crossing;
  tree.find_near(crossing);
  std::erase_if(crossing,
                [&](const TriangleCouple& pair) { return is_marked[pair[0]] == 0 && is_marked[pair[1]] == 0; });
  for (TriangleCouple& pair : crossing) std::sort(pair.begin(), pair.end());
  erase_apart(cloth, cloth, crossing);
  add_crossing_neighbours(cloth, is_marked, crossing);
  return to_sorted_pairs(std::move(crossing), cloth, cloth);
}

std::vector<CrossingPair> find_crossing_pairs(const Surface& cloth, const Surface& body) {
  if (cloth.triangles.empty() || body.triangles.empty()) return {};
  TriangleTree tree(cloth.triangles, cloth.positions_m), body_tree(body.triangles, body.positions_m);
  tree.fit(cloth.positions_m, cloth.positions_m.front(), 0.0);
  body_tree.fit(body.positions_m, cloth.positions_m.front(), 0.0);
  std::vector<TriangleCouple> crossing;
  tree.find_near(body_tree, crossing);
  erase_apart(cloth, body, crossing);
  return to_sorted_pairs(std::move(crossing), cloth, body);
}

}  // namespace taut::sim
