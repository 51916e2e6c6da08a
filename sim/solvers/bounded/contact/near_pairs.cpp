#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {
namespace {

/// Number of pairs of blocks compared at once. Higher values need more memory for results.
constexpr std::size_t max_block_pairs = 32;

bool is_any_marked(std::span<const Index> rows, std::span<const std::uint8_t> marks) {
  return std::any_of(rows.begin(), rows.end(), [&](Index row) { return marks[row] != 0; });
}

std::size_t height_for(const ContactMesh& mesh) {
  std::size_t max_count = 0;
  for (const Primitives* p : {&mesh.cloth, &mesh.bodies}) {
    max_count = std::max({max_count, p->vertices.size(), p->edges.size(), p->triangles.size()});
  }
  return BoxHierarchy::height_for(max_count);
}

}  // namespace

Float4 mean_position(const Float4Array& vectors) {
  Float4 mean{};
  for (const Float4& vector : vectors) add_scaled(mean, vector, 1.0F / static_cast<float>(vectors.size()));
  return mean;
}

void append_near(const MovingRows& rows, Index first_count, std::size_t count, const PairLists& lists,
                 const ContactKernels& kernels, std::vector<NearPair>& pairs) {
  const auto keep = first_count == 1 ? kernels.near_vertex_triangle : kernels.near_edges;
  const std::size_t near = keep(rows, count, lists);
  for (std::size_t i = 0; i < near; ++i) {
    pairs.push_back({{lists[0][i] / 4, lists[1][i] / 4, lists[2][i] / 4, lists[3][i] / 4}, first_count});
  }
}

NearPairs::Hierarchies NearPairs::make_hierarchies(const Primitives& primitives, std::span<const Vec3> positions,
                                                   std::size_t height) {
  return {BoxHierarchy(primitives.vertices, positions, height), BoxHierarchy(primitives.edges, positions, height),
          BoxHierarchy(primitives.triangles, positions, height)};
}

NearPairs::Hierarchies NearPairs::make_marked_hierarchies(const Hierarchies& all, std::span<const std::uint8_t> marks) {
  return {all.vertices.make_marked_subset(marks), all.edges.make_marked_subset(marks),
          all.triangles.make_marked_subset(marks)};
}

NearPairs::NearPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m)
    : within_cloth_(within_cloth),
      cloth_(make_hierarchies(mesh.cloth, positions_m, height_for(mesh))),
      bodies_(make_hierarchies(mesh.bodies, positions_m, height_for(mesh))),
      vertices_triangles_(shared_rows(cloth_.vertices.primitives(), cloth_.triangles.primitives())),
      edges_edges_(shared_rows(cloth_.edges.primitives(), cloth_.edges.primitives())) {}

/// Calls take(lists, count) with the overlaps of the block pairs [begin, end) of a level, in turn.
template <typename Take>
void NearPairs::for_found(const Trees& trees, std::size_t level, std::size_t begin, std::size_t end,
                          const ContactKernels& kernels, const Take& take) const {
  constexpr std::size_t size = max_block_pairs * max_pairs_per_block_pair + list_padding;
  const std::unique_ptr<std::uint32_t[]> room(new std::uint32_t[4 * size]);
  const PairLists found_lists = {&room[0], &room[size], &room[2 * size], &room[3 * size]};
  const BlockLanePairs* shared = level == 0 ? trees.shared : nullptr;
  for (std::size_t p = begin; p < end; p += max_block_pairs) {
    const BlockPairs blocks = {blocks_[0].data() + p, blocks_[1].data() + p, std::min(max_block_pairs, end - p),
                               shared};
    take(found_lists, kernels.overlapping(trees.a.level(level), trees.b.level(level), blocks, found_lists));
  }
}

/// Finds the pairs of blocks of primitives whose boxes overlap.
void NearPairs::find_blocks(const Trees& trees, const ContactKernels& kernels) {
  for (auto& blocks : blocks_) blocks.assign(1, 0);
  for (std::size_t level = trees.a.height() - 1; level > 0; --level) {
    for (auto& blocks : next_blocks_) blocks.clear();
    for_found(trees, level, 0, blocks_[0].size(), kernels, [&](const PairLists& found_lists, std::size_t count) {
      for (std::size_t k = 0; k < 2; ++k) {
        next_blocks_[k].insert(next_blocks_[k].end(), found_lists[k], found_lists[k] + count);
      }
    });
    std::swap(blocks_, next_blocks_);
  }
}

void NearPairs::find_between(const Trees& trees, const MovingRows& rows, ParallelKernels& kernels) {
  if (trees.a.is_empty() || trees.b.is_empty()) return;
  find_blocks(trees, kernels.contact());
  const auto first_count = static_cast<Index>(trees.a.corner_count());
  const std::size_t count = blocks_[0].size();
  parts_.resize(std::max(parts_.size(), count / ParallelKernels::min_pairs + 1));
  kernels.split(0, count, ParallelKernels::min_pairs, [&](std::size_t begin, std::size_t end) {
    // Ranges of other threads begin at least `min_pairs` away.
    std::vector<NearPair>& part = parts_[begin / ParallelKernels::min_pairs];
    for_found(trees, 0, begin, end, kernels.contact(), [&](const PairLists& found_lists, std::size_t candidates) {
      append_near(rows, first_count, candidates, found_lists, kernels.contact(), part);
    });
  });
  for (std::vector<NearPair>& part : parts_) {
    pairs_.insert(pairs_.end(), part.begin(), part.end());
    part.clear();
  }
}

MovingRows NearPairs::moving_rows(const Float4Array& positions, const Float4Array& moves,
                                  std::span<const float> radii) {
  assert(positions.size() == moves.size());
  assert(radii.size() <= positions.size());
  motions_.resize(moves.size());
  for (std::size_t row = 0; row < radii.size(); ++row) {
    motions_[row] = scaled_sum(moves[row], mean_motion_, -1.0F);
    motions_[row].fourth = radii[row];
  }
  return {positions.data(), motions_.data()};
}

void NearPairs::fit(const MovingRows& rows, ParallelKernels& kernels, Hierarchies& hierarchies) {
  hierarchies.vertices.fit(rows, kernels);
  hierarchies.edges.fit(rows, kernels);
  hierarchies.triangles.fit(rows, kernels);
}

void NearPairs::round(const BoxGrid& grid, ParallelKernels& kernels, Hierarchies& hierarchies) {
  hierarchies.vertices.round(grid, kernels);
  hierarchies.edges.round(grid, kernels);
  hierarchies.triangles.round(grid, kernels);
}

const std::vector<NearPair>& NearPairs::find(const Float4Array& positions, const Float4Array& moves,
                                             std::span<const float> radii, ParallelKernels& kernels) {
  assert(positions.size() == moves.size());
  mean_motion_ = mean_position(moves);
  const MovingRows rows = moving_rows(positions, moves, radii);
  fit(rows, kernels, cloth_);
  fit(rows, kernels, bodies_);
  grid_ = cloth_.vertices.grid();
  round(grid_, kernels, cloth_);
  round(grid_, kernels, bodies_);
  pairs_.clear();
  if (within_cloth_) {
    find_between({cloth_.vertices, cloth_.triangles, &vertices_triangles_}, rows, kernels);
    find_between({cloth_.edges, cloth_.edges, &edges_edges_}, rows, kernels);
  }
  find_between({cloth_.vertices, bodies_.triangles}, rows, kernels);
  find_between({bodies_.vertices, cloth_.triangles}, rows, kernels);
  find_between({cloth_.edges, bodies_.edges}, rows, kernels);
  return pairs_;
}

template <typename Keep>
void NearPairs::find_some_between(const Trees& trees, const MovingRows& rows, const Keep& keep,
                                  ParallelKernels& kernels) {
  const auto before = static_cast<std::ptrdiff_t>(pairs_.size());
  find_between(trees, rows, kernels);
  const auto is_left_out = [&](const NearPair& pair) { return !keep(pair); };
  pairs_.erase(std::remove_if(pairs_.begin() + before, pairs_.end(), is_left_out), pairs_.end());
}

// Trees of marked primitives are fitted and compared with the complete trees, which are not fitted: marked primitives
// of the latter are skipped, and found by comparing the small trees with each other.
const std::vector<NearPair>& NearPairs::find_anew(std::span<const std::uint8_t> marks, const Float4Array& positions,
                                                  const Float4Array& moves, std::span<const float> radii,
                                                  ParallelKernels& kernels) {
  assert(positions.size() == moves.size());
  assert(marks.size() <= positions.size());
  const MovingRows rows = moving_rows(positions, moves, radii);
  Hierarchies cloth = make_marked_hierarchies(cloth_, marks);
  Hierarchies bodies = make_marked_hierarchies(bodies_, marks);
  fit(rows, kernels, cloth);
  fit(rows, kernels, bodies);
  round(grid_, kernels, cloth);
  round(grid_, kernels, bodies);
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(),
                              [&](const NearPair& pair) { return is_any_marked(pair.rows, marks); }),
               pairs_.end());
  const auto any = [](const NearPair&) { return true; };
  const auto first_is_other = [&](const NearPair& pair) {
    return !is_any_marked(std::span(pair.rows).first(pair.first_count), marks);
  };
  const auto second_is_other = [&](const NearPair& pair) {
    return !is_any_marked(std::span(pair.rows).subspan(pair.first_count), marks);
  };
  const auto find_both_ways = [&](const BoxHierarchy& a, const BoxHierarchy& all_a, const BoxHierarchy& b,
                                  const BoxHierarchy& all_b) {
    find_some_between({a, b}, rows, any, kernels);
    find_some_between({a, all_b}, rows, second_is_other, kernels);
    if (&a != &b) find_some_between({all_a, b}, rows, first_is_other, kernels);
  };
  if (within_cloth_) {
    find_both_ways(cloth.vertices, cloth_.vertices, cloth.triangles, cloth_.triangles);
    find_both_ways(cloth.edges, cloth_.edges, cloth.edges, cloth_.edges);
  }
  find_both_ways(cloth.vertices, cloth_.vertices, bodies.triangles, bodies_.triangles);
  find_both_ways(bodies.vertices, bodies_.vertices, cloth.triangles, cloth_.triangles);
  find_both_ways(cloth.edges, cloth_.edges, bodies.edges, bodies_.edges);
  return pairs_;
}

}  // namespace taut::sim::bounded
