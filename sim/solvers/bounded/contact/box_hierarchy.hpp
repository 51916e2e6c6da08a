#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

/// Tree of boxes around vertices, edges or triangles; every node has the 16 children of one block. Its shape is fixed
/// by the initial positions. Later only the boxes are fitted again, as neighbours in cloth stay neighbours.
class BoxHierarchy {
 public:
  /// Primitives of one, two or three corners, by solver index. `positions` has one entry per solver index. Trees that
  /// are traversed together need the same height, at least the height of the higher one.
  BoxHierarchy(std::span<const std::array<Index, 1>> vertices, std::span<const Vec3> positions, std::size_t height);
  BoxHierarchy(std::span<const Edge> edges, std::span<const Vec3> positions, std::size_t height);
  BoxHierarchy(std::span<const Triangle> triangles, std::span<const Vec3> positions, std::size_t height);

  /// Returns a tree of the same height of the primitives with a marked corner. One mark per solver index.
  BoxHierarchy make_marked_subset(std::span<const std::uint8_t> marks) const;

  /// Returns the height of a tree with this many primitives.
  static std::size_t height_for(std::size_t count);

  /// Fits the boxes to all positions that the primitives can reach.
  void fit(const MovingRows& rows, ParallelKernels& kernels);
  /// Returns the finest grid that covers the primitives.
  BoxGrid grid() const;
  /// Rounds the boxes of the last fit() for level().
  void round(const BoxGrid& grid, ParallelKernels& kernels);

  const PrimitiveLanes& primitives() const { return primitives_; }
  bool is_empty() const { return primitives_.count == 0; }
  /// Returns the number of corners of each primitive.
  std::size_t corner_count() const { return primitives_.corner_count; }
  /// Returns the number of levels below the root.
  std::size_t height() const { return levels_.size() - 1; }
  /// Returns a level. Level 0 has the boxes of the primitives, each other one the boxes around the blocks of the level
  /// below. Requires a level below the height.
  BoxLevel level(std::size_t level) const {
    return {rounded_[level].data(), rounded_[level + 1].data(), level == 0 ? &primitives_ : nullptr};
  }

 private:
  BoxHierarchy() = default;

  template <std::size_t corners>
  void build(std::span<const std::array<Index, corners>> primitives, std::span<const Vec3> positions,
             std::size_t height);
  void add_levels(std::size_t height);

  PrimitiveLanes primitives_;
  std::vector<Lanes<BoxBlock>> levels_;  ///< the last level has one box
  std::vector<Lanes<RoundedBoxes>> rounded_;
};

}  // namespace taut::sim::bounded
