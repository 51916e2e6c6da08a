#pragma once

#include "sim/solvers/bounded/contact/box_hierarchy.hpp"
#include "sim/solvers/bounded/contact/contact_mesh.hpp"
#include "sim/solvers/bounded/contact/near_pair.hpp"
#include "sim/solvers/bounded/contact/shared_rows.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

Float4 mean_of(const Float4Array& vectors);

/// Appends those of the first `count` pairs of the lists that could meet, see ContactKernels. It changes the
/// lists.
void append_near(const MovingRows& rows, Index first_count, std::size_t count, const PairLists& lists,
                 const ContactKernels& kernels, std::vector<NearPair>& pairs);

/// Finds what is near in a mesh that moves.
class NearPairs {
 public:
  /// `positions` are those of the mesh when it begins to move, one per row.
  /// Pairs within the cloth are found only if asked for.
  NearPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m);

  /// Finds all pairs that could meet while every row moves by `moves`, or by up to `radii` more or less:
  /// those whose boxes, around all that their corners can reach, may overlap on their ways, and that are
  /// nearer than ContactKernels says. Pairs within the bodies are left out. In m, one entry per row each. The
  /// order depends on the mesh and on which pairs are found, and on nothing else.
  const std::vector<NearPair>& find(const Float4Array& positions, const Float4Array& moves,
                                    std::span<const float> radii, ParallelKernels& kernels);

  /// Finds pairs anew after only marked rows have come to move otherwise or further; all others are as they
  /// were found. One mark per row, not 0 where it is marked.
  const std::vector<NearPair>& find_anew(std::span<const std::uint8_t> marks, const Float4Array& positions,
                                         const Float4Array& moves, std::span<const float> radii,
                                         ParallelKernels& kernels);

 private:
  struct Hierarchies {
    BoxHierarchy vertices, edges, triangles;
  };
  /// Two trees that are gone through side by side. They may be the same.
  struct Trees {
    const BoxHierarchy& a;
    const BoxHierarchy& b;
    const BlockLanePairs* shared = nullptr;  ///< where it is known
  };

  static Hierarchies hierarchies_of(const Primitives& primitives, std::span<const Vec3> positions,
                                    std::size_t least_height);
  static Hierarchies of_marked(const Hierarchies& all, std::span<const std::uint8_t> marks);
  static void fit(const MovingRows& rows, ParallelKernels& kernels, Hierarchies& hierarchies);
  static void round(const BoxGrid& grid, ParallelKernels& kernels, Hierarchies& hierarchies);
  MovingRows moving_rows(const Float4Array& positions, const Float4Array& moves, std::span<const float> radii);
  template <typename Keep>
  void find_some_between(const Trees& trees, const MovingRows& rows, const Keep& keep, ParallelKernels& kernels);
  void find_between(const Trees& trees, const MovingRows& rows, ParallelKernels& kernels);
  void find_blocks(const Trees& trees, const ContactKernels& kernels);
  template <typename Take>
  void for_found(const Trees& trees, std::size_t level, std::size_t begin, std::size_t end,
                 const ContactKernels& kernels, const Take& take) const;

  bool within_cloth_;
  Hierarchies cloth_;
  Hierarchies bodies_;
  BlockLanePairs vertices_triangles_;  ///< what shares a row, in the cloth
  BlockLanePairs edges_edges_;
  BoxGrid grid_;      ///< of the cloth when all was gone through
  Float4 together_;   ///< what all rows move alike, which does not bring them nearer and makes boxes larger
  Float4Array ways_;  ///< see MovingRows
  std::array<Lanes<std::uint32_t>, 2> blocks_;  ///< pairs of blocks of one level
  std::array<Lanes<std::uint32_t>, 2> next_blocks_;
  std::vector<std::vector<NearPair>> parts_;  ///< of what is found, by where a thread began
  std::vector<NearPair> pairs_;
};

}  // namespace taut::sim::bounded
