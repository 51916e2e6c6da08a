#pragma once

#include "sim/mesh/types.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

/// A tree of boxes around vertices, edges or triangles, in which every node has the 16 children of one block.
/// Its shape is decided once, by where the primitives are then; as they move only the boxes are fitted again,
/// since what lies side by side in cloth stays side by side.
class BoxHierarchy {
 public:
  /// Primitives of one, two or three corners, by row. `positions` has one entry per row. Trees that are gone
  /// through side by side need the same height, at least that of the higher one.
  BoxHierarchy(std::span<const std::array<Index, 1>> vertices, std::span<const Vec3> positions, std::size_t height);
  BoxHierarchy(std::span<const Edge> edges, std::span<const Vec3> positions, std::size_t height);
  BoxHierarchy(std::span<const Triangle> triangles, std::span<const Vec3> positions, std::size_t height);

  /// Returns a tree of the same height of those primitives of which a row is marked. One mark per row.
  BoxHierarchy of_marked(std::span<const std::uint8_t> marks) const;

  /// Returns the height that a tree of so many primitives needs.
  static std::size_t height_for(std::size_t count);

  /// Fits the boxes to all that the primitives can reach.
  void fit(const MovingRows& rows, ParallelKernels& kernels);
  /// Returns the grid that is finest where the primitives are.
  BoxGrid grid() const;
  /// Rounds the boxes as they were fitted last, for level().
  void round(const BoxGrid& grid, ParallelKernels& kernels);

  const PrimitiveLanes& primitives() const { return primitives_; }
  bool is_empty() const { return primitives_.count == 0; }
  /// Of each of its primitives.
  std::size_t corner_count() const { return primitives_.corner_count; }
  /// How many levels there are below the box around all.
  std::size_t height() const { return levels_.size() - 1; }
  /// Level 0 has the boxes of the primitives, and each other one those around the blocks of the level below
  /// it. Requires a level below the height.
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
  std::vector<Lanes<BoxBlock>> levels_;  ///< the last one has one box
  std::vector<Lanes<RoundedBoxes>> rounded_;
};

}  // namespace taut::sim::bounded
