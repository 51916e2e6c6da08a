#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/solvers/bounded/kernels/float4.hpp"

namespace taut::sim::bounded {

/// `block_size` boxes, side by side in memory, in m. Those in padding are empty: from infinity to minus
/// infinity.
struct alignas(64) BoxBlock {
  std::array<std::array<float, block_size>, 3> low;
  std::array<std::array<float, block_size>, 3> high;
};

/// Boxes of whole numbers, `block_size` side by side. Those in padding overlap none.
struct alignas(64) RoundedBoxes {
  std::array<std::array<std::int16_t, block_size>, 3> low;
  std::array<std::array<std::int16_t, block_size>, 3> high;
};

/// Takes coordinates to whole numbers from -32767 to 32766: (x - origin) * per_m without its fraction, or the nearest
/// of these. Numbers that are less or equal stay so, and boxes that overlap do.
struct BoxGrid {
  std::array<float, 3> origin = {};  ///< in m
  std::array<float, 3> per_m = {1.0F, 1.0F, 1.0F};
};

/// For each lane of a block some lanes of another: bit i for lane i.
using LanePairs = std::array<std::uint16_t, block_size>;

/// Lanes of blocks of two lists that belong together.
struct BlockLanePairs {
  std::vector<std::uint32_t> begin = {0};  ///< by block of the one list, of its entries in the others
  std::vector<std::uint32_t> blocks;       ///< of the other list
  std::vector<LanePairs> lanes;

  /// Returns those of two blocks.
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
  std::size_t corner_count = 0;  ///< of each: 1, 2 or 3
  std::size_t count = 0;         ///< without padding
  /// Per corner and primitive, where the row of the corner begins, counted in floats.
  std::array<Lanes<std::uint32_t>, 3> at;

  std::size_t block_count() const { return (count + block_size - 1) / block_size; }
};

/// How rows move, one entry per row, in m.
struct MovingRows {
  /// Where they are.
  const Float4* places;
  /// Where to they move from there; `unused` is how much more or less that may be.
  const Float4* ways;
};

/// Some boxes, and the boxes around each block of them.
struct BoxLevel {
  const RoundedBoxes* boxes;
  const RoundedBoxes* around;
  /// The primitives that the boxes enclose; null where they enclose other boxes.
  const PrimitiveLanes* primitives;
};

struct BlockPairs {
  const std::uint32_t* first;
  const std::uint32_t* second;
  std::size_t count;
  const BlockLanePairs* left_out = nullptr;  ///< what is not looked for, if it is known
};

/// Four lists of the same length.
using PairLists = std::array<std::uint32_t*, 4>;

/// Vectors are loaded and stored whole at the end of a list: this many entries more than it has must be
/// there.
inline constexpr std::size_t list_padding = block_size;
/// How many entries one pair of blocks can give.
inline constexpr std::size_t most_per_block_pair = block_size * block_size;

/// They divide by at least this, in m^2 or m^4.
inline constexpr float smallest_divisor = 1e-30F;

/// The loops of the search for what is near. Results and their order are the same for any width
/// of vectors.
struct ContactKernels {
  /// Sets the boxes around all that primitives in blocks [begin, end) can reach.
  void (*enclose)(const PrimitiveLanes& primitives, std::size_t begin, std::size_t end, const MovingRows& rows,
                  BoxBlock* boxes);

  /// Sets the boxes around blocks [begin, end), each a lane of `around`.
  void (*enclose_blocks)(const BoxBlock* boxes, std::size_t begin, std::size_t end, BoxBlock* around);

  /// Sets the boxes of blocks [begin, end).
  void (*round_boxes)(const BoxBlock* boxes, std::size_t begin, std::size_t end, const BoxGrid& grid,
                      RoundedBoxes* rounded);

  /// For each pair of blocks, the one of `a` and the other of `b`, finds the pairs of lanes whose
  /// boxes overlap, but for those that are left out; of a block with itself, each two lanes once, and each lane
  /// with itself.
  /// If `a` and `b` are of primitives, those that share a row are left out, and `found` gets where the rows
  /// of their corners begin: a list for each corner of the one and then of the other. Otherwise it gets the
  /// lanes themselves in its first two lists. Returns the length of these lists.
  std::size_t (*overlapping)(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, const PairLists& found);

  /// Keeps those of the first `count` pairs of a vertex and a triangle that could meet, in their order, and
  /// returns their number. A pair stays apart if, along the line between its two nearest points, every
  /// corner of the one is ahead of every corner of the other, before and after their ways, by more than both
  /// may move besides. Motion that both share does not matter, nor do ways across that line.
  /// Rounding loses nothing: pairs that are apart by 1e-5 of their radii too much, or by 1e-6 of the longest
  /// distance between corners and the longest difference of their ways, may be kept too, and so may those
  /// that nearly touch, where the line is uncertain.
  std::size_t (*near_vertex_triangle)(const MovingRows& rows, std::size_t count, const PairLists& pairs);

  /// The same for pairs of edges.
  std::size_t (*near_edges)(const MovingRows& rows, std::size_t count, const PairLists& pairs);

  /// Lists the rows of blocks [begin, end) whose displacements are not where they are expected, and returns
  /// how many these are: further from `since` + time `moves` than `unused` of the moves says, or not numbers.
  /// In m, one entry per row each.
  std::size_t (*off_their_ways)(const Float4* since, const Float4* moves, float time, std::size_t begin,
                                std::size_t end, const Float4* displacements, std::uint32_t* rows);
};

}  // namespace taut::sim::bounded
