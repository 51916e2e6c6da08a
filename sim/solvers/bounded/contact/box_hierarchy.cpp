#include "sim/solvers/bounded/contact/box_hierarchy.hpp"

#include "sim/mesh/extent.hpp"
#include "sim/mesh/preconditions.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

BoxBlock empty_boxes() {
  BoxBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.low[axis].fill(infinite);
    block.high[axis].fill(-infinite);
  }
  return block;
}

std::size_t blocks_for(std::size_t count) { return (count + block_size - 1) / block_size; }

/// Orders primitives so that the primitives of a block are spatial neighbours, and so are the blocks of a larger block,
/// and so on. Sorts each block, as the order left by std::nth_element depends on the standard library.
void order_by_place(std::span<const Vec3> centres, std::span<Index> things) {
  if (things.size() <= block_size) {
    std::sort(things.begin(), things.end());
    return;
  }
  std::size_t part = block_size;
  while (part * block_size < things.size()) part *= block_size;
  const std::size_t parts = (things.size() + part - 1) / part;
  const std::size_t middle = (parts + 1) / 2 * part;
  Extent extent;
  for (const Index thing : things) extent.add(centres[thing]);
  const int axis = long_axis(extent);
  std::nth_element(things.begin(), things.begin() + static_cast<std::ptrdiff_t>(middle), things.end(),
                   [&](Index a, Index b) {
                     return centres[a][axis] < centres[b][axis] || (centres[a][axis] == centres[b][axis] && a < b);
                   });
  order_by_place(centres, things.first(middle));
  order_by_place(centres, things.subspan(middle));
}

template <std::size_t corners>
std::vector<Index> spatial_order(std::span<const std::array<Index, corners>> primitives,
                                 std::span<const Vec3> positions) {
  std::vector<Vec3> centres;
  for (const auto& rows : primitives) {
    Vec3 sum(0.0);
    for (const Index row : rows) sum += positions[row];
    centres.push_back(sum / static_cast<double>(corners));
  }
  std::vector<Index> order(primitives.size());
  std::iota(order.begin(), order.end(), 0U);
  order_by_place(centres, order);
  return order;
}

}  // namespace

BoxHierarchy::BoxHierarchy(std::span<const std::array<Index, 1>> vertices, std::span<const Vec3> positions,
                           std::size_t height) {
  build(vertices, positions, height);
}
BoxHierarchy::BoxHierarchy(std::span<const Edge> edges, std::span<const Vec3> positions, std::size_t height) {
  build(edges, positions, height);
}
BoxHierarchy::BoxHierarchy(std::span<const Triangle> triangles, std::span<const Vec3> positions, std::size_t height) {
  build(triangles, positions, height);
}

std::size_t BoxHierarchy::height_for(std::size_t count) {
  std::size_t height = 1;
  for (std::size_t blocks = blocks_for(count); blocks > 1; blocks = blocks_for(blocks)) ++height;
  return height;
}

template <std::size_t corners>
void BoxHierarchy::build(std::span<const std::array<Index, corners>> primitives, std::span<const Vec3> positions,
                         std::size_t height) {
  assert(are_below(primitives, positions.size()));
  assert(height > 0);
  primitives_.corner_count = corners;
  primitives_.count = primitives.size();
  const std::vector<Index> order = spatial_order(primitives, positions);
  const std::size_t blocks = blocks_for(primitives.size());
  for (std::size_t k = 0; k < corners; ++k) {
    primitives_.at[k].assign(blocks * block_size, 0);
    for (std::size_t lane = 0; lane < order.size(); ++lane) {
      primitives_.at[k][lane] = 4 * primitives[order[lane]][k];
    }
  }
  add_levels(height);
}

void BoxHierarchy::add_levels(std::size_t height) {
  levels_.emplace_back(primitives_.block_count(), empty_boxes());
  for (std::size_t level = 0; level < height; ++level) {
    levels_.emplace_back(std::max<std::size_t>(blocks_for(levels_.back().size()), 1), empty_boxes());
  }
  for (const Lanes<BoxBlock>& boxes : levels_) rounded_.emplace_back(boxes.size());
}

// Primitives keep their order, so neighbours stay neighbours.
BoxHierarchy BoxHierarchy::make_marked_subset(std::span<const std::uint8_t> marks) const {
  BoxHierarchy some;
  some.primitives_.corner_count = primitives_.corner_count;
  for (std::size_t lane = 0; lane < primitives_.count; ++lane) {
    bool is_marked = false;
    for (std::size_t k = 0; k < primitives_.corner_count; ++k) {
      is_marked |= marks[primitives_.at[k][lane] / 4] != 0;
    }
    if (is_marked) {
      for (std::size_t k = 0; k < primitives_.corner_count; ++k) {
        some.primitives_.at[k].push_back(primitives_.at[k][lane]);
      }
      ++some.primitives_.count;
    }
  }
  for (std::size_t k = 0; k < primitives_.corner_count; ++k) {
    some.primitives_.at[k].resize(some.primitives_.block_count() * block_size, 0);
  }
  some.add_levels(height());
  return some;
}

void BoxHierarchy::fit(const MovingRows& rows, ParallelKernels& kernels) {
  kernels.enclose(primitives_, rows, levels_[0].data());
  for (std::size_t l = 0; l < height(); ++l) {
    kernels.enclose_blocks(levels_[l].data(), levels_[l].size(), levels_[l + 1].data());
  }
}

BoxGrid BoxHierarchy::grid() const {
  // Slightly less than 16 bits, so that outliers have numbers too.
  constexpr float grid_numbers = 65530.0F;
  constexpr float min_grid_size_m = 1e-3F;
  const BoxBlock& all = levels_.back().front();
  BoxGrid grid;
  for (std::size_t axis = 0; axis < 3 && all.low[axis][0] <= all.high[axis][0]; ++axis) {
    grid.origin[axis] = 0.5F * (all.low[axis][0] + all.high[axis][0]);
    grid.per_m[axis] = grid_numbers / std::max(all.high[axis][0] - all.low[axis][0], min_grid_size_m);
  }
  return grid;
}

void BoxHierarchy::round(const BoxGrid& grid, ParallelKernels& kernels) {
  for (std::size_t l = 0; l < levels_.size(); ++l) kernels.round_boxes(levels_[l], grid, rounded_[l].data());
}

}  // namespace taut::sim::bounded
