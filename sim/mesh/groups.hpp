#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Sets of items that can be joined: union-find with path halving (Tarjan and van Leeuwen 1984). A set is
/// named by its smallest item.
class Groups {
 public:
  /// Starts with the items 0 to size - 1, each a set of its own.
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  /// The name of the set that holds the item.
  Index find(Index item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

 private:
  std::vector<Index> parent_;
};

/// Returns groups of vertices that these edges or triangles connect.
template <class Simplices> Groups connected(std::size_t vertex_count, const Simplices& simplices) {
  Groups groups(vertex_count);
  for (const auto& simplex : simplices) {
    for (const Index v : simplex) groups.join(simplex[0], v);
  }
  return groups;
}

}  // namespace taut::sim
