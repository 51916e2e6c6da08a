#include "sim/solvers/bounded/contact/near_pairs.hpp"

#include <algorithm>

namespace taut::sim::bounded {
namespace {

/// So many pairs of blocks are gone through at once. More need more room for what they may give.
constexpr std::size_t most_at_once = 32;
/// A thread takes at least so many pairs of blocks.
constexpr std::size_t least_pairs = 256;

}  // namespace

NearPairs::Hierarchies NearPairs::hierarchies_of(const Primitives& primitives,
                                                 std::span<const Vec3> positions) {
  return {BoxHierarchy(primitives.vertices, positions), BoxHierarchy(primitives.edges, positions),
          BoxHierarchy(primitives.triangles, positions)};
}

NearPairs::NearPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m)
    : within_cloth_(within_cloth),
      cloth_(hierarchies_of(mesh.cloth, positions_m)),
      bodies_(hierarchies_of(mesh.bodies, positions_m)) {
  std::size_t height = 0;
  for (const Hierarchies* h : {&cloth_, &bodies_}) {
    height = std::max({height, h->vertices.height(), h->edges.height(), h->triangles.height()});
  }
  for (Hierarchies* h : {&cloth_, &bodies_}) {
    h->vertices.raise(height);
    h->edges.raise(height);
    h->triangles.raise(height);
  }
}

/// Calls take(lists, count) with what is found between pairs [begin, end) of blocks of a level, in turn.
template <typename Take>
void NearPairs::for_found(const Trees& trees, std::size_t level, std::size_t begin, std::size_t end,
                          const ContactKernels& kernels, const Take& take) const {
  std::array<Lanes<std::uint32_t>, 4> room;
  PairLists found{};
  for (std::size_t k = 0; k < room.size(); ++k) {
    room[k].resize(most_at_once * most_per_block_pair + list_padding);
    found[k] = room[k].data();
  }
  for (std::size_t p = begin; p < end; p += most_at_once) {
    const BlockPairs blocks = {blocks_[0].data() + p, blocks_[1].data() + p, std::min(most_at_once, end - p)};
    take(found, kernels.overlapping(trees.a.level(level), trees.b.level(level), blocks, found));
  }
}

/// Finds the pairs of blocks of primitives whose boxes overlap.
void NearPairs::find_blocks(const Trees& trees, const ContactKernels& kernels) {
  for (auto& blocks : blocks_) {
    blocks.assign(1, 0);
  }
  for (std::size_t level = trees.a.height() - 1; level > 0; --level) {
    for (auto& blocks : next_blocks_) {
      blocks.clear();
    }
    for_found(trees, level, 0, blocks_[0].size(), kernels, [&](const PairLists& found, std::size_t count) {
      for (std::size_t k = 0; k < 2; ++k) {
        next_blocks_[k].insert(next_blocks_[k].end(), found[k], found[k] + count);
      }
    });
    std::swap(blocks_, next_blocks_);
  }
}

void NearPairs::find_between(const Trees& trees, const MovingRows& rows, ParallelKernels& kernels) {
  if (trees.a.is_empty() || trees.b.is_empty()) {
    return;
  }
  find_blocks(trees, kernels.contact());
  const auto first_count = static_cast<Index>(trees.a.corner_count());
  const auto keep_near =
      first_count == 1 ? kernels.contact().near_vertex_triangle : kernels.contact().near_edges;
  const std::size_t count = blocks_[0].size();
  parts_.resize(std::max(parts_.size(), count / least_pairs + 1));
  kernels.split(0, count, least_pairs, [&](std::size_t begin, std::size_t end) {
    // No other part begins so near.
    std::vector<NearPair>& part = parts_[begin / least_pairs];
    for_found(trees, 0, begin, end, kernels.contact(), [&](const PairLists& found, std::size_t candidates) {
      const std::size_t near = keep_near(rows, candidates, found);
      for (std::size_t i = 0; i < near; ++i) {
        part.push_back({{found[0][i] / 4, found[1][i] / 4, found[2][i] / 4, found[3][i] / 4}, first_count});
      }
    });
  });
  for (std::vector<NearPair>& part : parts_) {
    pairs_.insert(pairs_.end(), part.begin(), part.end());
    part.clear();
  }
}

const std::vector<NearPair>& NearPairs::find(const Float4Array& positions, const Float4Array& moves,
                                             std::span<const float> radii, ParallelKernels& kernels) {
  ways_ = moves;
  for (std::size_t row = 0; row < radii.size(); ++row) {
    ways_[row].unused = radii[row];
  }
  const MovingRows rows = {positions.data(), ways_.data()};
  for (Hierarchies* h : {&cloth_, &bodies_}) {
    h->vertices.fit(rows, kernels);
    h->edges.fit(rows, kernels);
    h->triangles.fit(rows, kernels);
  }
  pairs_.clear();
  if (within_cloth_) {
    find_between({cloth_.vertices, cloth_.triangles}, rows, kernels);
    find_between({cloth_.edges, cloth_.edges}, rows, kernels);
  }
  find_between({cloth_.vertices, bodies_.triangles}, rows, kernels);
  find_between({bodies_.vertices, cloth_.triangles}, rows, kernels);
  find_between({cloth_.edges, bodies_.edges}, rows, kernels);
  return pairs_;
}

}  // namespace taut::sim::bounded
