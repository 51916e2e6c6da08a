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

/// Items that face the same side or opposite sides, as pairs of them imply.
class FacingGroups {
 public:
  explicit FacingGroups(std::size_t size) : size_(size), groups_(2 * size) {}

  /// Returns whether two items face opposite sides; nothing if no pair implies it.
  std::optional<bool> opposite(std::size_t a, std::size_t b) {
    const Index side = find(b);
    if (find(a) == side) return false;
    return find(a + size_) == side ? std::optional(true) : std::nullopt;
  }
  /// Adds a pair, unless earlier pairs imply how its items face each other.
  void join(std::size_t a, std::size_t b, bool are_opposite) {
    if (opposite(a, b)) return;
    groups_.join(find(a), find(are_opposite ? b + size_ : b));
    groups_.join(find(a + size_), find(are_opposite ? b : b + size_));
  }

 private:
  Index find(std::size_t side) { return groups_.find(static_cast<Index>(side)); }

  std::size_t size_;
  Groups groups_;  ///< item + `size_` stands for the other side of the item
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
