#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tailor/mannequin/polygonise.hpp"

namespace taut::tailor {
namespace {

using sim::Index;
using sim::Triangle;

/// Minimum distance of inner vertices from x = 0, because their mirror images are as near.
constexpr double min_border_distance_m = 0.004;

/// A mesh that changes. Removed triangles have three equal corners.
class Remesher {
 public:
  Remesher(const Shape& shape, sim::Mesh mesh) : shape_(shape), mesh_(std::move(mesh)) {
    around_.resize(mesh_.positions.size());
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      for (const Index v : mesh_.triangles[t]) {
        around_[v].push_back(t);
      }
    }
    for (const Vec3& p : mesh_.positions) {
      wanted_m_.push_back(edge_length_m(shape_, p));
    }
  }

  void round() {
    for_every_edge([this](Index a, Index b) { split_long(a, b); });
    for_every_edge([this](Index a, Index b) { collapse_short(a, b); });
    for_every_edge([this](Index a, Index b) { flip_uneven(a, b); });
    compact();
    relax(shape_, mesh_);
    *this = Remesher(shape_, std::move(mesh_));
  }

  sim::Mesh& mesh() { return mesh_; }

  Remesher& operator=(Remesher&& other) noexcept {
    mesh_ = std::move(other.mesh_);
    around_ = std::move(other.around_);
    wanted_m_ = std::move(other.wanted_m_);
    return *this;
  }

 private:
  static constexpr double longest = 4.0 / 3.0;
  static constexpr double shortest = 4.0 / 5.0;

  template <class Change>
  void for_every_edge(Change&& change) {
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle triangle = mesh_.triangles[t];
        const Index a = triangle[k];
        const Index b = triangle[(k + 1) % 3];
        if (a != b) {
          change(a, b);
        }
      }
    }
  }

  const Vec3& at(Index v) const { return mesh_.positions[v]; }
  bool on_border(Index v) const { return at(v).x == 0.0; }
  double relative_length(Index a, Index b) const {
    return glm::length(at(a) - at(b)) / (0.5 * (wanted_m_[a] + wanted_m_[b]));
  }

  static bool has(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }
  static Index third(const Triangle& t, Index a, Index b) {
    return t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
  }

  std::vector<Index> triangles_at(Index a, Index b) const {
    std::vector<Index> result;
    for (const Index t : around_[a]) {
      if (has(mesh_.triangles[t], b)) {
        result.push_back(t);
      }
    }
    return result;
  }

  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> result;
    for (const Index t : around_[v]) {
      for (const Index other : mesh_.triangles[t]) {
        if (other != v && std::find(result.begin(), result.end(), other) == result.end()) {
          result.push_back(other);
        }
      }
    }
    return result;
  }

  void leave(Index v, Index t) { std::erase(around_[v], t); }

  void replace(Index t, Index from, Index to) {
    for (Index& v : mesh_.triangles[t]) {
      v = v == from ? to : v;
    }
    around_[to].push_back(t);
  }

  void split_long(Index a, Index b) {
    const std::vector<Index> shared = triangles_at(a, b);
    const double length_m = glm::length(at(a) - at(b));
    // Splits only longest sides, because needles would be cut into ever thinner ones.
    const bool is_longest = std::all_of(shared.begin(), shared.end(), [&](Index t) {
      const Vec3& c = at(third(mesh_.triangles[t], a, b));
      return length_m >= glm::length(c - at(a)) && length_m >= glm::length(c - at(b));
    });
    if (relative_length(a, b) <= longest || !is_longest) {
      return;
    }
    const Index middle = static_cast<Index>(mesh_.positions.size());
    mesh_.positions.push_back(0.5 * (at(a) + at(b)));
    wanted_m_.push_back(0.5 * (wanted_m_[a] + wanted_m_[b]));
    around_.emplace_back();
    for (const Index t : shared) {
      Triangle other = mesh_.triangles[t];
      for (Index& v : other) {
        v = v == a ? middle : v;
      }
      leave(b, t);
      replace(t, b, middle);
      for (const Index v : other) {
        around_[v].push_back(static_cast<Index>(mesh_.triangles.size()));
      }
      mesh_.triangles.push_back(other);
    }
  }

  /// Returns true if the triangles of `v`, except those that have `but`, keep their orientation when it moves to
  /// `there`.
  bool may_move(Index v, Index but, const Vec3& there) const {
    for (const Index t : around_[v]) {
      Triangle triangle = mesh_.triangles[t];
      if (has(triangle, but)) {
        continue;
      }
      while (triangle[0] != v) {
        std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
      }
      const Vec3 side = at(triangle[2]) - at(triangle[1]);
      const Vec3 before = glm::cross(side, at(v) - at(triangle[1]));
      const Vec3 after = glm::cross(side, there - at(triangle[1]));
      const bool turns = glm::dot(before, after) < 0.3 * glm::length(before) * glm::length(after);
      if (turns || glm::length(there - at(triangle[1])) > longest * wanted_m_[triangle[1]] ||
          glm::length(there - at(triangle[2])) > longest * wanted_m_[triangle[2]]) {
        return false;
      }
    }
    return true;
  }

  void collapse_short(Index a, Index b) {
    if (relative_length(a, b) >= shortest) {
      return;
    }
    const std::vector<Index> shared = triangles_at(a, b);
    if (on_border(a) && on_border(b) && shared.size() != 1) {
      return;
    }
    const std::vector<Index> near_a = neighbours(a);
    const std::vector<Index> near_b = neighbours(b);
    const auto common = std::count_if(near_a.begin(), near_a.end(), [&near_b](Index v) {
      return std::find(near_b.begin(), near_b.end(), v) != near_b.end();
    });
    if (static_cast<std::size_t>(common) != shared.size()) {
      return;
    }
    const Vec3 there = on_border(a) == on_border(b) ? 0.5 * (at(a) + at(b)) : on_border(a) ? at(a) : at(b);
    if (!may_move(a, b, there) || !may_move(b, a, there)) {
      return;
    }
    collapse(a, b, shared);
    mesh_.positions[a] = there;
  }

  void collapse(Index a, Index b, const std::vector<Index>& shared) {
    for (const Index t : shared) {
      const Triangle dead = mesh_.triangles[t];
      for (const Index v : dead) {
        leave(v, t);
      }
      mesh_.triangles[t] = {a, a, a};
    }
    for (const Index t : std::vector<Index>(around_[b])) {
      replace(t, b, a);
    }
    around_[b].clear();
  }

  double excess(Index v, int change) const {
    const double ideal = on_border(v) ? 3.0 : 6.0;
    const double e = static_cast<double>(around_[v].size()) + change - ideal;
    return e * e;
  }

  void flip_uneven(Index a, Index b) {
    const std::vector<Index> shared = triangles_at(a, b);
    if (shared.size() != 2) {
      return;
    }
    const Index c = third(mesh_.triangles[shared[0]], a, b);
    const Index d = third(mesh_.triangles[shared[1]], a, b);
    const double before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const double after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    if (after >= before || !triangles_at(c, d).empty() || (on_border(c) && on_border(d)) ||
        !stays_convex(a, b, c, d)) {
      return;
    }
    leave(b, shared[0]);
    leave(a, shared[1]);
    replace(shared[0], b, d);
    replace(shared[1], a, c);
  }

  bool stays_convex(Index a, Index b, Index c, Index d) const {
    const Vec3 normal = glm::cross(at(b) - at(a), at(c) - at(a)) + glm::cross(at(d) - at(a), at(b) - at(a));
    const Vec3 first = glm::cross(at(d) - at(a), at(c) - at(a));
    const Vec3 second = glm::cross(at(c) - at(b), at(d) - at(b));
    const double least = 0.5 * glm::length(normal);
    return glm::dot(first, normal) > least * glm::length(first) &&
           glm::dot(second, normal) > least * glm::length(second);
  }

  void compact() {
    sim::Mesh kept;
    std::vector<Index> number(mesh_.positions.size(), ~Index{0});
    for (const Triangle& t : mesh_.triangles) {
      if (t[0] == t[1]) {
        continue;
      }
      Triangle renumbered;
      for (std::size_t k = 0; k < 3; ++k) {
        if (number[t[k]] == ~Index{0}) {
          number[t[k]] = static_cast<Index>(kept.positions.size());
          kept.positions.push_back(at(t[k]));
        }
        renumbered[k] = number[t[k]];
      }
      kept.triangles.push_back(renumbered);
    }
    mesh_ = std::move(kept);
  }

  const Shape& shape_;
  sim::Mesh mesh_;
  std::vector<std::vector<Index>> around_;
  std::vector<double> wanted_m_;
};

}  // namespace

sim::Mesh even_out(const Shape& shape, const sim::Mesh& half, int rounds) {
  Remesher remesher(shape, half);
  for (int i = 0; i < rounds; ++i) {
    remesher.round();
  }
  return std::move(remesher.mesh());
}

void relax(const Shape& shape, sim::Mesh& half) {
  const std::size_t count = half.positions.size();
  std::vector<Vec3> sums(count, Vec3(0.0));
  std::vector<Vec3> normals(count, Vec3(0.0));
  std::vector<double> weights(count, 0.0);
  const auto pull = [&](Index v, Index to) {
    if (half.positions[v].x != 0.0 || half.positions[to].x == 0.0) {
      sums[v] += half.positions[to];
      weights[v] += 1.0;
    }
  };
  for (const Triangle& t : half.triangles) {
    const Vec3 area = sim::doubled_area_vector(half.positions, t);
    for (std::size_t k = 0; k < 3; ++k) {
      normals[t[k]] += area;
      pull(t[k], t[(k + 1) % 3]);
      pull(t[k], t[(k + 2) % 3]);
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    Vec3& p = half.positions[v];
    const bool border = p.x == 0.0;
    const Vec3 outward = border ? Vec3(0.0, normals[v].y, normals[v].z) : normals[v];
    const Vec3 normal = outward / std::max(glm::length(outward), 1e-12);
    const Vec3 step = weights[v] > 0.0 ? sums[v] / weights[v] - p : Vec3(0.0);
    const Vec3 moved = on_surface(shape, p + 0.6 * (step - glm::dot(step, normal) * normal));
    if (border || moved.x > min_border_distance_m) {
      p = {border ? 0.0 : moved.x, moved.y, moved.z};
    }
  }
}

}  // namespace taut::tailor
