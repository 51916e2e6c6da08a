#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Union-find with path halving (Tarjan and van Leeuwen 1984). A set is named by its smallest item.
class Groups {
 public:
  /// Starts with one set for each of the items 0 to size - 1.
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  /// Returns the name of the item's set.
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

/// Returns the groups of vertices connected by these edges or triangles.
template <class Simplices> Groups connect_vertices(std::size_t vertex_count, const Simplices& simplices) {
  Groups groups(vertex_count);
  for (const auto& simplex : simplices) {
    for (const Index v : simplex) groups.join(simplex[0], v);
  }
  return groups;
}

}  // namespace taut::sim
