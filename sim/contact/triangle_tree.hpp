#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Two triangles, by their places in the lists that their trees were made of.
using TriangleCouple = std::array<Index, 2>;

/// Finds which triangles may be near each other: boxes around boxes, in single precision.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// `positions_m` are where the mesh is cut into boxes, for all times.
  TriangleTree(std::span<const Triangle> triangles, std::span<const Vec3> positions_m);

  /// Takes up where the vertices are now, seen from an origin. Triangles within `reach_m` of each other after this are
  /// found; it should be the same in trees that are compared.
  void fit(std::span<const Vec3> positions_m, const Vec3& origin_m, double reach_m);

  /// Appends all pairs of triangles that may be within the reach and share no vertex, each once.
  void find_near(std::vector<TriangleCouple>& pairs) const;
  /// Appends all pairs of a triangle of this one and one of another mesh that may be within the reach.
  void find_near(const TriangleTree& other, std::vector<TriangleCouple>& pairs) const;

 private:
  static constexpr std::size_t lanes = 8;
  struct Box {
    std::array<float, 3> lower, upper;
  };
  /// The boxes of so many triangles side by side; those that are not there are empty.
  struct Leaf {
    float lower[3][lanes];
    float upper[3][lanes];
  };
  /// A triangle as its corners and their mean, coordinate by coordinate.
  struct Place {
    float x[4], y[4], z[4];
  };
  /// A range of leaves with its place among the nodes: those of its first half follow it, then those of the other.
  struct Node {
    std::size_t at, begin, end;
    std::size_t size() const { return end - begin; }
    Node first() const { return {at + 1, begin, begin + size() / 2}; }
    Node second() const { return {at + 2 * (size() / 2), begin + size() / 2, end}; }
  };

  void order(std::size_t begin, std::size_t end, std::span<const Vec3> middles_m);
  Node root() const { return {0, 0, leaves_.size()}; }
  Box fit(const Node& node);
  void fit_leaf(std::size_t leaf, std::span<const std::array<float, 3>> corners);
  void find_within(const Node& node, std::vector<TriangleCouple>& pairs) const;
  void find_between(const Node& node, const TriangleTree& other, const Node& others,
                    std::vector<TriangleCouple>& pairs) const;
  void compare(const Node& node, const TriangleTree& other, const Node& others,
               std::vector<TriangleCouple>& pairs) const;
  static std::array<int, lanes> which_meet(const Leaf& leaf, const Box& box);
  bool may_be_near(std::size_t place, const TriangleTree& other, std::size_t others) const;

  std::vector<Index> order_;         ///< of triangles, by their boxes
  std::vector<Triangle> triangles_;  ///< in that order
  std::vector<Leaf> leaves_;
  std::vector<Place> places_;
  std::vector<Box> boxes_;  ///< of nodes
  float reach_m_ = 0.0F;
};

}  // namespace taut::sim
