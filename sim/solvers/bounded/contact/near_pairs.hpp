#pragma once

#include "sim/solvers/bounded/contact/box_hierarchy.hpp"
#include "sim/solvers/bounded/contact/contact_mesh.hpp"
#include "sim/solvers/bounded/contact/near_pair.hpp"
#include "sim/solvers/bounded/contact/shared_rows.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

Float4 mean_position(const Float4Array& vectors);

/// Appends the pairs among the first `count` of the lists that could meet, see ContactKernels. Changes the lists.
void append_near(const MovingRows& rows, Index first_count, std::size_t count, const PairLists& lists,
                 const ContactKernels& kernels, std::vector<NearPair>& pairs);

/// Finds near pairs in a moving mesh.
class NearPairs {
 public:
  /// `positions_m` are the initial positions, one per solver index. Pairs within the cloth are found only if
  /// `within_cloth`.
  NearPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m);

  /// Finds all pairs that could meet if every vertex moves by `moves`, give or take `radii`: the swept boxes overlap
  /// and the distance is as ContactKernels says. Pairs within the bodies are left out. Arguments are in m, with one
  /// entry per solver index. The order depends only on the mesh and on the set of pairs.
  const std::vector<NearPair>& find(const Float4Array& positions, const Float4Array& moves,
                                    std::span<const float> radii, ParallelKernels& kernels);

  /// Updates the pairs after a change of the motions or radii of marked vertices only. One mark per solver index, not 0
  /// if marked.
  const std::vector<NearPair>& find_anew(std::span<const std::uint8_t> marks, const Float4Array& positions,
                                         const Float4Array& moves, std::span<const float> radii,
                                         ParallelKernels& kernels);

 private:
  struct Hierarchies {
    BoxHierarchy vertices, edges, triangles;
  };
  /// Two trees traversed together; they may be the same.
  struct Trees {
    const BoxHierarchy& a;
    const BoxHierarchy& b;
    const BlockLanePairs* shared = nullptr;  ///< primitives with a common vertex, if known
  };

  static Hierarchies make_hierarchies(const Primitives& primitives, std::span<const Vec3> positions,
                                      std::size_t min_height_ratio);
  static Hierarchies make_marked_hierarchies(const Hierarchies& all, std::span<const std::uint8_t> marks);
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
  BlockLanePairs vertices_triangles_;  ///< primitives of the cloth with a common vertex
  BlockLanePairs edges_edges_;
  BoxGrid grid_;                                ///< grid of the last search of the whole mesh
  Float4 mean_motion_;                          ///< mean motion, which brings nothing nearer but makes boxes larger
  Float4Array motions_;                         ///< see MovingRows
  std::array<Lanes<std::uint32_t>, 2> blocks_;  ///< pairs of blocks of one level
  std::array<Lanes<std::uint32_t>, 2> next_blocks_;
  std::vector<std::vector<NearPair>> parts_;  ///< found pairs by the start of the thread's range
  std::vector<NearPair> pairs_;
};

}  // namespace taut::sim::bounded
