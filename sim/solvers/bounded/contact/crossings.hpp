#pragma once

#include "sim/contact/triangle_pair.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/solvers/bounded/contact/near_pair.hpp"

namespace taut::sim::bounded {

/// Two things of the cloth that are nearer at rest than this, in m, are not kept apart: half of it is what single
/// precision tells apart.
inline constexpr double least_at_rest_m = 2e-6;

/// Patches around crossings at the start: the triangles on both sides of each contour and
/// two rings of triangles around them. Patches that pierce each other or overlap are one group. Two things, each a
/// vertex, an edge or a triangle, are left out of contact where both lie in one group: all triangles that they are of
/// belong to it. So nothing begins to cross but two triangles of one group: of two others some part that meets first is
/// of a triangle outside, and is kept apart. When nothing in a group crosses or touches any more, it is no group.
class Crossings {
 public:
  Crossings() = default;
  /// `cloth` and `bodies` are triangles of rows. Distances of the cloth at rest are those at `rest_m`, in m, one entry
  /// per row of the cloth.
  Crossings(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
            std::vector<Vec3> rest_m);

  /// Makes patches around all that crosses or touches, of the cloth with bodies and, if asked for, with itself. In m,
  /// one entry per row.
  void add(std::span<const Vec3> positions_m);
  /// Frees the groups that are apart.
  void free(std::span<const Vec3> positions_m);

  bool empty() const { return keys_.empty(); }

  /// Returns, by triangle of the cloth, whether parts of it touch others at rest, and are not kept apart from
  /// them. Empty where none do.
  const std::vector<bool>& touch_at_rest() const { return touch_at_rest_; }

  /// Returns whether both things lie in one group.
  bool has(const NearPair& near) const;

  /// The group of each triangle, first of the cloth, then of bodies: 0 where it is of none.
  std::span<const Index> groups() const { return group_of_; }
  void set_groups(std::vector<Index> group_of);

 private:
  /// The rows of a vertex, an edge or a triangle, sorted, the last one repeated, and its group.
  struct Key {
    Triangle rows;
    Index group;
    bool operator==(const Key&) const = default;
    bool operator<(const Key& other) const { return std::tie(rows, group) < std::tie(other.rows, other.group); }
  };

  TrianglePairMeasure measure(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const;
  bool is_kept_apart(Index s, Index t, bool are_neighbours) const;
  bool is_apart(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const;
  template <typename Each>
  void for_pairs(std::span<const Index> among, std::span<const Vec3> positions_m, double reach_m,
                 const Each& each) const;
  void find_touching_at_rest();
  void find_keys();
  Index group_of(std::span<const Index> rows) const;

  bool within_cloth_ = false;
  std::size_t cloth_count_ = 0;
  std::vector<Triangle> triangles_;  ///< of the cloth, then of bodies
  CompressedRows triangles_of_;      ///< by row
  std::vector<Vec3> rest_m_;
  std::vector<Index> group_of_;  ///< by triangle
  std::vector<Key> keys_;        ///< of what lies in groups, sorted
  std::vector<bool> touch_at_rest_;
};

}  // namespace taut::sim::bounded
