#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Indices of two triangles, in the lists their trees were made of.
using TriangleCouple = std::array<Index, 2>;

/// Tree of boxes in single precision, which finds triangles that may be near each other.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// The tree is built once, at `positions_m`.
  TriangleTree(std::span<const Triangle> triangles, std::span<const Vec3> positions_m);

  /// Updates the boxes to these positions, relative to an origin. Later searches find triangles within `reach_m`, which
  /// should be equal in trees that are compared.
  void fit(std::span<const Vec3> positions_m, const Vec3& origin_m, double reach_m);

  /// Limits find_near() within the tree to pairs of which one is marked, or in the same leaf as a marked one.
  void search_marked(std::span<const std::uint8_t> is_marked);

  /// Appends all pairs of triangles without a common vertex that may be within reach, each once.
  void find_near(std::vector<TriangleCouple>& pairs) const;
  /// Appends all pairs of a triangle of this tree and one of another mesh that may be within reach.
  void find_near(const TriangleTree& other, std::vector<TriangleCouple>& pairs) const;

 private:
  static constexpr std::size_t lanes = 8;
  struct TreeBox {
    std::array<float, 3> lower, upper;
  };
  /// Boxes of `lanes` triangles side by side; missing ones are NaN.
  struct Leaf {
    float lower[3][lanes];
    float upper[3][lanes];
  };
  /// Corners of a triangle and their mean, by coordinate.
  struct TreeTriangle {
    float x[4], y[4], z[4];
  };
  /// Range of leaves with its index among the nodes: the nodes of its first half follow it, then the nodes of the
  /// second.
  struct TreeNode {
    std::size_t at, begin, end;
    std::size_t size() const { return end - begin; }
    TreeNode first() const { return {at + 1, begin, begin + size() / 2}; }
    TreeNode second() const { return {at + 2 * (size() / 2), begin + size() / 2, end}; }
  };

  /// Pairs of lanes of a leaf and another that are never near: bit `lanes` i + j for lane i and the other's lane j.
  struct ExcludedLanes {
    std::size_t other;
    std::uint64_t bits;
  };

  void order(std::size_t begin, std::size_t end, std::span<const Vec3> middles_m);
  void exclude_neighbours(std::size_t vertices);
  void exclude(std::size_t place, std::size_t other);
  std::uint64_t excluded_between(std::size_t leaf, std::size_t other) const;
  TreeNode root() const { return {0, 0, leaves_.size()}; }
  TreeBox fit(const TreeNode& node);
  bool mark(const TreeNode& node, std::span<const std::uint8_t> is_marked);
  bool may_search(const TreeNode& node) const { return searched_.empty() || searched_[node.at] != 0; }
  void fit_leaf(std::size_t leaf, std::span<const std::array<float, 3>> corners);
  void find_within(const TreeNode& node, std::vector<TriangleCouple>& pairs) const;
  void find_between(const TreeNode& node, const TriangleTree& other, const TreeNode& others,
                    std::vector<TriangleCouple>& pairs) const;
  void compare(const TreeNode& node, const TriangleTree& other, const TreeNode& others,
               std::vector<TriangleCouple>& pairs) const;
  /// Returns as bits which boxes of a leaf overlap a box.
  static std::uint32_t find_overlaps(const Leaf& leaf, const TreeBox& box);
  bool may_be_near(std::size_t place, const TriangleTree& other, std::size_t others) const;

  std::vector<Index> order_;         ///< triangle indices in leaf order
  std::vector<Triangle> triangles_;  ///< triangles in leaf order
  std::vector<Leaf> leaves_;
  std::vector<TreeTriangle> places_;
  std::vector<ExcludedLanes> excluded_;      ///< triangles with a common vertex, by leaf
  std::vector<std::size_t> excluded_begin_;  ///< first entry of each leaf
  std::vector<TreeBox> boxes_;               ///< boxes by node
  std::vector<std::uint8_t> searched_;       ///< nodes with a marked triangle; empty: all
  float reach_m_ = 0.0F;
};

}  // namespace taut::sim
