#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim::bounded {

/// All points between two corners, in m.
struct Box {
  float low[3];
  float high[3];
};

inline bool overlap(const Box& a, const Box& b) {
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1] &&
         a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
}

inline Box union_of(const Box& a, const Box& b) {
  Box both;
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = std::min(a.low[axis], b.low[axis]);
    both.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return both;
}

/// A binary tree of boxes. Its shape is decided once, by where the things are then; as they move only the
/// boxes are fitted again, since what lies side by side in cloth stays side by side.
class BoxTree {
 public:
  /// `centres` has one entry per thing.
  explicit BoxTree(std::span<const Vec3> centres);

  /// Fits the tree to the boxes of the things.
  void fit(std::span<const Box> boxes);

  /// Calls each(a, b) once for every two different things whose boxes overlap, in an order that depends on
  /// the boxes alone.
  template <typename Each>
  void for_overlapping(std::span<const Box> boxes, const Each& each) const;

 private:
  struct Node {
    Box box;
    /// Things [begin, end) in the order of the tree. A node of one thing has no children; others have this
    /// node's successor as the one and `second` as the other child.
    Index begin;
    Index end;
    Index second;
  };

  Index add_node(std::span<const Vec3> centres, Index begin, Index end);
  bool is_leaf(Index node) const { return nodes_[node].second == 0; }

  std::vector<Index> order_;  ///< things
  std::vector<Node> nodes_;   ///< a node before its children
};

template <typename Each>
void BoxTree::for_overlapping(std::span<const Box> boxes, const Each& each) const {
  if (nodes_.empty()) {
    return;
  }
  std::vector<Edge> to_do = {{0, 0}};
  while (!to_do.empty()) {
    const auto [a, b] = to_do.back();
    to_do.pop_back();
    const Node& node_a = nodes_[a];
    const Node& node_b = nodes_[b];
    if (a != b && !overlap(node_a.box, node_b.box)) {
      continue;
    }
    if (is_leaf(a) && is_leaf(b)) {
      for (Index i = node_a.begin; i < node_a.end; ++i) {
        for (Index j = a == b ? i + 1 : node_b.begin; j < node_b.end; ++j) {
          if (overlap(boxes[order_[i]], boxes[order_[j]])) {
            each(order_[i], order_[j]);
          }
        }
      }
    } else if (a == b) {
      to_do.push_back({a + 1, node_a.second});
      to_do.push_back({node_a.second, node_a.second});
      to_do.push_back({a + 1, a + 1});
    } else if (is_leaf(b) || (!is_leaf(a) && node_a.end - node_a.begin >= node_b.end - node_b.begin)) {
      to_do.push_back({node_a.second, b});
      to_do.push_back({a + 1, b});
    } else {
      to_do.push_back({a, node_b.second});
      to_do.push_back({a, b + 1});
    }
  }
}

}  // namespace taut::sim::bounded
