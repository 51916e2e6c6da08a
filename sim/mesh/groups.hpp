#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Union-find with path halving. A group is named by its smallest item.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  Index find(Index item) {
    while (parent_[item] != item) {
      item = parent_[item] = parent_[parent_[item]];
    }
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

}  // namespace taut::sim
