#pragma once

#include "sim/contact/triangle_pair.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/solvers/bounded/contact/near_pair.hpp"

namespace taut::sim::bounded {

/// Smallest rest distance in m of cloth primitives that contact keeps apart: twice the resolution of single precision.
inline constexpr double min_rest_distance_m = 2e-6;

/// Patches around crossings at the start: the triangles on both sides of each contour and two rings of triangles around
/// them. Patches that pierce each other or overlap form one group. Contact leaves out two primitives (vertex, edge or
/// triangle) in the same group; a primitive is in a group if all of its triangles are. So new crossings are possible
/// only between two triangles of one group: for any other two, the primitives that meet first include one of a triangle
/// outside, which is kept apart. A group ends when nothing in it crosses or touches.
class Crossings {
 public:
  Crossings() = default;
  /// `cloth` and `bodies` are triangles by solver index. `rest_m` are the cloth's rest positions for distances at rest,
  /// in m, one entry per solver index of the cloth.
  Crossings(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
            std::vector<Vec3> rest_m);

  /// Makes patches around all crossings and touches of the cloth with bodies and, if asked for, with itself.
  /// `positions_m` has one entry per solver index.
  void add(std::span<const Vec3> positions_m);
  /// Frees the groups without crossings and touches.
  void free(std::span<const Vec3> positions_m);

  bool empty() const { return keys_.empty(); }

  /// Returns, by triangle of the cloth, whether it touches others at rest, from which contact does not keep it apart.
  /// Empty if none do.
  const std::vector<bool>& touch_at_rest() const { return is_touching_at_rest_; }

  /// Returns whether both primitives are in one group.
  bool has(const NearPair& near) const;

  /// Returns the group of each triangle, first of the cloth, then of bodies; 0 without a group.
  std::span<const Index> groups() const { return triangle_groups_; }
  void set_groups(std::vector<Index> find_group);

 private:
  /// Solver indices of a vertex, an edge or a triangle, sorted, the last one repeated, and its group.
  struct Key {
    Triangle rows;
    Index group;
    bool operator==(const Key&) const = default;
    bool operator<(const Key& other) const { return std::tie(rows, group) < std::tie(other.rows, other.group); }
  };

  TrianglePairMeasure measure(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const;
  bool lie_apart(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const;
  bool is_kept_apart(Index s, Index t, bool are_neighbours) const;
  bool is_apart(Index s, Index t, bool are_neighbours, std::span<const Vec3> positions_m) const;
  template <typename Each>
  void for_pairs(std::span<const Index> among, std::span<const Vec3> positions_m, double reach_m,
                 const Each& each) const;
  void find_touching_at_rest();
  void find_keys();
  Index find_group(std::span<const Index> rows) const;

  bool within_cloth_ = false;
  std::size_t cloth_count_ = 0;
  std::vector<Triangle> triangles_;  ///< triangles of the cloth, then of bodies
  CompressedRows row_triangles_;     ///< triangles by solver index
  std::vector<Vec3> rest_m_;
  std::vector<Index> triangle_groups_;  ///< group by triangle
  std::vector<Key> keys_;               ///< primitives in groups, sorted
  std::vector<bool> is_touching_at_rest_;
};

}  // namespace taut::sim::bounded
