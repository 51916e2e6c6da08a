#include "sim/solvers/bounded/contact/box_tree.hpp"

#include <numeric>

namespace taut::sim::bounded {
namespace {

/// Things in a leaf. With more, fewer boxes of nodes and more boxes of things are compared.
constexpr Index most_in_leaf = 4;

int longest_axis(std::span<const Vec3> centres, std::span<const Index> things) {
  Vec3 low = centres[things[0]];
  Vec3 high = low;
  for (const Index thing : things) {
    low = glm::min(low, centres[thing]);
    high = glm::max(high, centres[thing]);
  }
  const Vec3 size = high - low;
  return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

}  // namespace

BoxTree::BoxTree(std::span<const Vec3> centres) : order_(centres.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!centres.empty()) {
    add_node(centres, 0, static_cast<Index>(centres.size()));
  }
}

Index BoxTree::add_node(std::span<const Vec3> centres, Index begin, Index end) {
  const auto node = static_cast<Index>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0});
  if (end - begin > most_in_leaf) {
    const std::span<Index> things(order_.data() + begin, end - begin);
    const int axis = longest_axis(centres, things);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(things.begin(), things.begin() + (middle - begin), things.end(), [&](Index a, Index b) {
      return centres[a][axis] < centres[b][axis] || (centres[a][axis] == centres[b][axis] && a < b);
    });
    add_node(centres, begin, middle);
    const Index second = add_node(centres, middle, end);
    nodes_[node].second = second;
  }
  return node;
}

void BoxTree::fit(std::span<const Box> boxes) {
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    if (node.second != 0) {
      node.box = union_of(nodes_[n + 1].box, nodes_[node.second].box);
      continue;
    }
    node.box = boxes[order_[node.begin]];
    for (Index k = node.begin + 1; k < node.end; ++k) {
      node.box = union_of(node.box, boxes[order_[k]]);
    }
  }
}

}  // namespace taut::sim::bounded
