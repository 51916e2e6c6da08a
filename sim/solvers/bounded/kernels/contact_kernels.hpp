#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// `block_size` boxes side by side in memory, in m. Padding boxes are empty: from infinity to minus infinity.
struct alignas(64) BoxBlock {
  std::array<std::array<float, block_size>, 3> low;
  std::array<std::array<float, block_size>, 3> high;
};

/// `block_size` boxes of whole numbers. Padding boxes overlap none.
struct alignas(64) RoundedBoxes {
  std::array<std::array<std::int16_t, block_size>, 3> low;
  std::array<std::array<std::int16_t, block_size>, 3> high;
};

/// Maps coordinates to whole numbers from -32767 to 32766: (x - origin) * per_m without its fraction, clamped. The map
/// is monotonic, so boxes that overlap still do.
struct BoxGrid {
  std::array<float, 3> origin = {};  ///< origin in m
  std::array<float, 3> per_m = {1.0F, 1.0F, 1.0F};
};

/// Set of lanes of another block for each lane of a block: bit i for lane i.
using LanePairs = std::array<std::uint16_t, block_size>;

/// Sparse pairs of lanes of the blocks of two lists.
struct BlockLanePairs {
  std::vector<std::uint32_t> begin = {0};  ///< start of each block of the first list in the other arrays
  std::vector<std::uint32_t> blocks;       ///< block of the second list
  std::vector<LanePairs> lanes;

  /// Returns the lane pairs of two blocks.
  const LanePairs& between(std::uint32_t block_a, std::uint32_t block_b) const {
    static constexpr LanePairs none = {};
    for (std::size_t i = begin[block_a]; i < begin[block_a + 1]; ++i) {
      if (blocks[i] == block_b) return lanes[i];
    }
    return none;
  }
};

/// Vertices, edges or triangles, padded to whole blocks.
struct PrimitiveLanes {
  std::size_t corner_count = 0;  ///< corners per primitive: 1, 2 or 3
  std::size_t count = 0;         ///< without padding
  /// Offset in floats of each corner's Float4, per corner and primitive: 4 times the solver index.
  std::array<Lanes<std::uint32_t>, 3> at;

  std::size_t block_count() const { return (count + block_size - 1) / block_size; }
};

/// Motion of vertices, one entry per vertex, in m.
struct MovingRows {
  /// Positions at the start.
  const Float4* positions;
  /// Motion from there; `fourth` is its tolerance in any direction.
  const Float4* motions;
};

/// One level of boxes, and the boxes around its blocks.
struct BoxLevel {
  const RoundedBoxes* boxes;
  const RoundedBoxes* around;
  /// Primitives in the boxes; null if they enclose other boxes.
  const PrimitiveLanes* primitives;
};

struct BlockPairs {
  const std::uint32_t* first;
  const std::uint32_t* second;
  std::size_t count;
  const BlockLanePairs* excluded = nullptr;  ///< excluded pairs, if known
};

/// What the planes of pairs depend on; one entry per vertex, in m.
struct PairRows {
  const Float4* positions;
  const Float4* moves;    ///< predicted motion
  const Float4* normals;  ///< normals of any length; `fourth` is positive where they are known
  const Float4* extents;  ///< x: distance from the origin; y: largest motion
  float displaced;        ///< see PairExtent
};

/// `block_size` pairs of one kind side by side in memory, in m.
struct alignas(64) PairBlock {
  template <typename T> using Of = std::array<T, block_size>;

  std::array<Of<std::uint32_t>, 4> at = {};  ///< offset of each corner in floats: 4 times the solver index
  Of<float> thickness = {};
  std::array<Of<float>, 3> normal;   ///< unit vector towards the first primitive
  std::array<Of<float>, 4> heights;  ///< heights of the corners along it
  std::array<Of<float>, 4> weights;  ///< weights of the closest points, see ClosestWeights
  Of<float> distance;                ///< distance along the normal
  Of<float> error;                   ///< its rounding error, see distance_error_m()
};

/// Four lists of the same length.
using PairLists = std::array<std::uint32_t*, 4>;

/// Padding entries at the end of a list, as vectors are loaded and stored whole.
inline constexpr std::size_t list_padding = block_size;
/// Largest number of results of one pair of blocks.
inline constexpr std::size_t max_pairs_per_block_pair = block_size * block_size;

/// Smallest divisor in the kernels, in m^2 or m^4.
inline constexpr float min_divisor = 1e-30F;

/// Kernels of the search for near pairs. Results and their order are the same for any width of vectors.
struct ContactKernels {
  /// Sets the swept boxes of the primitives in blocks [begin, end).
  void (*enclose)(const PrimitiveLanes& primitives, std::size_t begin, std::size_t end, const MovingRows& rows,
                  BoxBlock* boxes);

  /// Sets the boxes around blocks [begin, end), each one lane of `around`.
  void (*enclose_blocks)(const BoxBlock* boxes, std::size_t begin, std::size_t end, BoxBlock* around);

  /// Rounds the boxes of blocks [begin, end).
  void (*round_boxes)(const BoxBlock* boxes, std::size_t begin, std::size_t end, const BoxGrid& grid,
                      RoundedBoxes* rounded);

  /// Finds, for each pair of a block of `a` and one of `b`, the pairs of lanes with overlapping boxes, except excluded
  /// ones. In a block with itself, each two lanes come once, and each lane with itself. If `a` and `b` hold primitives,
  /// pairs with a common vertex are skipped, and `found` gets the corners' offsets: one list per corner of the first,
  /// then of the second. Otherwise its first two lists get the lanes. Returns the length of the lists.
  std::size_t (*overlapping)(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, const PairLists& found);

  /// Keeps the pairs, among the first `count` of a vertex and a triangle, that could meet, in their order, and returns
  /// their number. A pair stays apart if, along the line between its closest points, every corner of one primitive is
  /// ahead of every corner of the other, before and after the motion, by more than the sum of their tolerances. Common
  /// motion and motion across that line do not matter. Rounding loses no pair: pairs too far apart by 1e-5 of their
  /// radii, or by 1e-6 of the largest distance or relative motion of corners, may be kept too, and so may nearly
  /// touching ones, whose line is uncertain.
  std::size_t (*near_vertex_triangle)(const MovingRows& rows, std::size_t count, const PairLists& pairs);

  /// Keeps the pairs of edges that could meet, like near_vertex_triangle.
  std::size_t (*near_edges)(const MovingRows& rows, std::size_t count, const PairLists& pairs);

  /// Sets all results of pairs of a vertex and a triangle.
  void (*place_triangle_planes)(const PairRows& rows, PairBlock& pairs);
  /// Sets all results of pairs of edges.
  void (*place_edge_planes)(const PairRows& rows, PairBlock& pairs);

  /// Set the distances of pairs of a vertex and a triangle, or of edges.
  void (*measure_triangle_distances)(const Float4* positions, PairBlock& pairs);
  void (*measure_edge_distances)(const Float4* positions, PairBlock& pairs);

  /// Lists the vertices of blocks [begin, end) that left their predicted motion, and returns their number: their
  /// displacement is not a number, or further from `since` + time `moves` than the fourth number of the motion. In m,
  /// one entry per vertex.
  std::size_t (*list_off_motion)(const Float4* since, const Float4* moves, float time, std::size_t begin,
                                 std::size_t end, const Float4* displacements, std::uint32_t* rows);
};

}  // namespace taut::sim::bounded
