// The kernels that find which boxes overlap, for the target being compiled. The file is included once per
// target, so its include guard is of another kind.
#if defined(TAUT_BOXES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_BOXES_INL
#undef TAUT_BOXES_INL
#else
#define TAUT_BOXES_INL
#endif

#include <bit>
#include <limits>

#include "sim/solvers/bounded/kernels/contact_kernels.hpp"
#include "sim/solvers/bounded/kernels/vectors_inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace taut::sim::bounded::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

using Integers = hn::RebindToUnsigned<Floats>;
using Mask = hn::Mask<Floats>;

struct Boxes {
  Triple low, high;
};

HWY_INLINE Triple load_lanes(const std::array<std::array<float, block_size>, 3>& values, std::size_t k) {
  const Floats f;
  return {hn::Load(f, &values[0][k]), hn::Load(f, &values[1][k]), hn::Load(f, &values[2][k])};
}

HWY_INLINE Triple repeat_lane(const std::array<std::array<float, block_size>, 3>& values, std::size_t lane) {
  const Floats f;
  return {hn::Set(f, values[0][lane]), hn::Set(f, values[1][lane]), hn::Set(f, values[2][lane])};
}

HWY_INLINE Boxes load_boxes(const BoxBlock& block, std::size_t k) {
  return {load_lanes(block.low, k), load_lanes(block.high, k)};
}

HWY_INLINE Boxes repeat_box(const BoxBlock& block, std::size_t lane) {
  return {repeat_lane(block.low, lane), repeat_lane(block.high, lane)};
}

HWY_INLINE Mask no_higher(const Triple& p, const Triple& q) {
  return hn::And(hn::And(hn::Le(p.x, q.x), hn::Le(p.y, q.y)), hn::Le(p.z, q.z));
}

HWY_INLINE Mask overlap(const Boxes& a, const Boxes& b) {
  return hn::And(no_higher(a.low, b.high), no_higher(b.low, a.high));
}

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Floats(), mask, bytes);
  const std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8;
  return bits & ((1U << lanes) - 1U);
}

/// For each set of lanes, where its lanes are, one after the other.
struct LaneTable {
  static constexpr std::size_t width = lanes < 16 ? lanes : 1;
  alignas(64) std::uint32_t at[std::size_t{1} << width][width] = {};

  constexpr LaneTable() {
    for (std::uint32_t set = 0; set < 1U << width; ++set) {
      std::size_t size = 0;
      for (std::uint32_t lane = 0; lane < width; ++lane) {
        if ((set >> lane & 1U) != 0) at[set][size++] = lane;
      }
    }
  }
};
/// Not in a function, as Highway's own (1.0.3), which is copied to the stack whenever it is used.
constexpr LaneTable lane_table;

/// Some lanes of vectors.
class Some {
 public:
  explicit HWY_INLINE Some(Mask mask) : mask_(mask), bits_(bits_of(mask)) {}

  HWY_INLINE std::size_t count() const { return static_cast<std::size_t>(std::popcount(bits_)); }

  /// Stores them one after the other, and anything behind them up to a whole vector.
  template <typename Tag, typename Vector, typename Value> HWY_INLINE void store(Tag tag, Vector v, Value* to) const {
    if constexpr (lanes == LaneTable::width) {
      hn::StoreU(hn::TableLookupLanes(v, hn::SetTableIndices(tag, lane_table.at[bits_])), tag, to);
    } else {
      hn::StoreU(hn::Compress(v, hn::RebindMask(tag, mask_)), tag, to);
    }
  }

 private:
  Mask mask_;
  std::uint32_t bits_;
};

/// Returns which boxes of a block may overlap the one box that `box` repeats.
HWY_INLINE std::uint32_t overlapping_bits(const Boxes& box, const BoxBlock& boxes) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < block_size; k += lanes) {
    bits |= bits_of(overlap(box, load_boxes(boxes, k))) << k;
  }
  return bits;
}

HWY_INLINE Triple lesser(const Triple& p, const Triple& q) {
  return {hn::Min(p.x, q.x), hn::Min(p.y, q.y), hn::Min(p.z, q.z)};
}
HWY_INLINE Triple greater(const Triple& p, const Triple& q) {
  return {hn::Max(p.x, q.x), hn::Max(p.y, q.y), hn::Max(p.z, q.z)};
}
HWY_INLINE Triple coordinates_of(const Four& m) { return {m.a, m.b, m.c}; }

HWY_INLINE Boxes reach_of(const MovingRows& rows, const std::uint32_t* at) {
  const Triple begin = as_coordinates(load_rows(floats_of(rows.places), at));
  const Four way = transposed(load_rows(floats_of(rows.ways), at));
  const Triple end = begin + coordinates_of(way);
  const Triple radius = {way.d, way.d, way.d};
  return {lesser(begin, end) - radius, greater(begin, end) + radius};
}

HWY_INLINE Boxes around(const Boxes& p, const Boxes& q) { return {lesser(p.low, q.low), greater(p.high, q.high)}; }

HWY_INLINE void store_or_empty(Mask is_some, const Triple& v, float otherwise, std::size_t k,
                               std::array<std::array<float, block_size>, 3>& values) {
  const Floats f;
  const V none = hn::Set(f, otherwise);
  hn::Store(hn::IfThenElse(is_some, v.x, none), f, &values[0][k]);
  hn::Store(hn::IfThenElse(is_some, v.y, none), f, &values[1][k]);
  hn::Store(hn::IfThenElse(is_some, v.z, none), f, &values[2][k]);
}

/// Returns which of the lanes from `first` on are below `count`.
HWY_INLINE Mask lanes_below(std::size_t first, std::size_t count) {
  const Integers u;
  return hn::RebindMask(
      Floats(), hn::Lt(hn::Iota(u, static_cast<std::uint32_t>(first)), hn::Set(u, static_cast<std::uint32_t>(count))));
}

HWY_INLINE void store_or_empty(Mask is_some, const Boxes& boxes, std::size_t k, BoxBlock& block) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  store_or_empty(is_some, boxes.low, infinite, k, block.low);
  store_or_empty(is_some, boxes.high, -infinite, k, block.high);
}

void enclose(const PrimitiveLanes& primitives, std::size_t begin, std::size_t end, const MovingRows& rows,
             BoxBlock* boxes) {
  for (std::size_t lane = begin * block_size; lane < end * block_size; lane += lanes) {
    Boxes reach = reach_of(rows, &primitives.at[0][lane]);
    for (std::size_t corner = 1; corner < primitives.corner_count; ++corner) {
      reach = around(reach, reach_of(rows, &primitives.at[corner][lane]));
    }
    const Mask is_some = lanes_below(lane, primitives.count);
    store_or_empty(is_some, reach, lane % block_size, boxes[lane / block_size]);
  }
}

HWY_INLINE void enclose_block(const BoxBlock& block, std::size_t lane, BoxBlock& around_blocks) {
  const Floats f;
  Boxes all = load_boxes(block, 0);
  for (std::size_t k = lanes; k < block_size; k += lanes) all = around(all, load_boxes(block, k));
  auto& [low, high] = around_blocks;
  low[0][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.x));
  low[1][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.y));
  low[2][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.z));
  high[0][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.x));
  high[1][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.y));
  high[2][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.z));
}

void enclose_blocks(const BoxBlock* boxes, std::size_t begin, std::size_t end, BoxBlock* around_blocks) {
  for (std::size_t b = begin; b < end; ++b) {
    enclose_block(boxes[b], b % block_size, around_blocks[b / block_size]);
  }
}

using Rows = hn::Vec<Integers>;

/// Of a block, what reaches a box, side by side in its order, and nothing up to the end of a whole vector.
template <std::size_t corners> struct Reaching {
  alignas(64) std::array<std::array<float, block_size + lanes>, 3> low;
  alignas(64) std::array<std::array<float, block_size + lanes>, 3> high;
  alignas(64) std::uint32_t rows[corners + 1][block_size + lanes];
  alignas(64) std::uint32_t lane[block_size + lanes];  ///< in the block
  std::size_t count = 0;
};

template <std::size_t corners>
HWY_INLINE void find_reaching(const Boxes& box, const BoxLevel& level, std::size_t block, Reaching<corners>& found) {
  const Floats f;
  const Integers u;
  found.count = 0;
  for (std::size_t k = 0; k < block_size; k += lanes) {
    const Boxes boxes = load_boxes(level.boxes[block], k);
    const Some some(overlap(box, boxes));
    const std::size_t at = found.count;
    some.store(f, boxes.low.x, &found.low[0][at]);
    some.store(f, boxes.low.y, &found.low[1][at]);
    some.store(f, boxes.low.z, &found.low[2][at]);
    some.store(f, boxes.high.x, &found.high[0][at]);
    some.store(f, boxes.high.y, &found.high[1][at]);
    some.store(f, boxes.high.z, &found.high[2][at]);
    for (std::size_t c = 0; c < corners; ++c) {
      const auto rows = hn::Load(u, &level.primitives->at[c][block * block_size + k]);
      some.store(u, rows, &found.rows[c][at]);
    }
    some.store(u, hn::Iota(u, static_cast<std::uint32_t>(k)), &found.lane[at]);
    found.count += some.count();
  }
  hn::StoreU(hn::Set(f, std::numeric_limits<float>::infinity()), f, &found.low[0][found.count]);
}

template <std::size_t corners> HWY_INLINE Boxes load_boxes(const Reaching<corners>& found, std::size_t k) {
  const Floats f;
  return {{hn::Load(f, &found.low[0][k]), hn::Load(f, &found.low[1][k]), hn::Load(f, &found.low[2][k])},
          {hn::Load(f, &found.high[0][k]), hn::Load(f, &found.high[1][k]), hn::Load(f, &found.high[2][k])}};
}

HWY_INLINE Boxes within_both(const Boxes& p, const Boxes& q) { return {greater(p.low, q.low), lesser(p.high, q.high)}; }

/// Returns which primitives share a row with the primitive in lane i of the level. Boxes of boxes share none.
template <std::size_t corners_a, std::size_t corners_b>
HWY_INLINE hn::Mask<Integers> sharing(const BoxLevel& a, std::size_t i, const Reaching<corners_b>& others,
                                      std::size_t k) {
  const Integers u;
  auto shares = hn::Lt(hn::Zero(u), hn::Zero(u));
  for (std::size_t c = 0; c < corners_a; ++c) {
    const Rows mine = hn::Set(u, a.primitives->at[c][i]);
    for (std::size_t d = 0; d < corners_b; ++d) {
      shares = hn::Or(shares, hn::Eq(mine, hn::Load(u, &others.rows[d][k])));
    }
  }
  return shares;
}

/// A pair of lanes of a pair of blocks as one number: stores are what this search waits for.
struct Code {
  static HWY_INLINE std::uint32_t first(std::size_t pair, std::uint32_t lane) {
    return static_cast<std::uint32_t>((pair * block_size + lane) * block_size);
  }
  static HWY_INLINE std::size_t pair_of(std::uint32_t code) { return code / (block_size * block_size); }
  static HWY_INLINE std::size_t lane_of_first(std::uint32_t code) { return code / block_size % block_size; }
  static HWY_INLINE std::size_t lane_of_second(std::uint32_t code) { return code % block_size; }
};

/// Lists pairs of lanes whose boxes overlap and that share no row. Two boxes overlap only where those around
/// their blocks do.
template <std::size_t corners_a, std::size_t corners_b>
std::size_t overlapping_codes(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, std::uint32_t* codes) {
  const Integers u;
  Reaching<corners_b> others;
  std::size_t size = 0;
  for (std::size_t p = 0; p < pairs.count; ++p) {
    const std::uint32_t block_a = pairs.first[p];
    const std::uint32_t block_b = pairs.second[p];
    const BoxBlock& mine = a.boxes[block_a];
    const bool is_same = &mine == &b.boxes[block_b];
    const Boxes both = within_both(repeat_box(a.around[block_a / block_size], block_a % block_size),
                                   repeat_box(b.around[block_b / block_size], block_b % block_size));
    std::uint32_t reaching = overlapping_bits(both, mine);
    if (reaching == 0) continue;
    find_reaching<corners_b>(both, b, block_b, others);
    for (; reaching != 0; reaching &= reaching - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(reaching));
      const Boxes box = repeat_box(mine, lane);
      const Rows first_code = hn::Set(u, Code::first(p, lane));
      // Within itself all of a block reaches, and what is before the lane has been its other.
      for (std::size_t k = is_same ? lane - lane % lanes : 0; k < others.count; k += lanes) {
        auto mask = hn::RebindMask(u, overlap(box, load_boxes(others, k)));
        if (hn::AllFalse(u, mask)) continue;
        const Rows lane_of_other = hn::Load(u, &others.lane[k]);
        mask = hn::AndNot(sharing<corners_a, corners_b>(a, std::size_t{block_a} * block_size + lane, others, k), mask);
        if (is_same) mask = hn::AndNot(hn::Lt(lane_of_other, hn::Set(u, lane)), mask);
        if (lanes < block_size && hn::AllFalse(u, mask)) continue;
        const Some some(hn::RebindMask(Floats(), mask));
        some.store(u, hn::Add(first_code, lane_of_other), codes + size);
        size += some.count();
      }
    }
  }
  return size;
}

std::size_t overlapping_lanes(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, const PairLists& found) {
  const std::size_t size = overlapping_codes<0, 0>(a, b, pairs, found[0]);
  for (std::size_t n = 0; n < size; ++n) {
    const std::uint32_t code = found[0][n];
    const std::size_t p = Code::pair_of(code);
    found[1][n] = static_cast<std::uint32_t>(pairs.second[p] * block_size + Code::lane_of_second(code));
    found[0][n] = static_cast<std::uint32_t>(pairs.first[p] * block_size + Code::lane_of_first(code));
  }
  return size;
}

template <std::size_t corners_a, std::size_t corners_b>
std::size_t overlapping_primitives(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs,
                                   const PairLists& found) {
  const std::uint32_t* mine[corners_a];
  for (std::size_t c = 0; c < corners_a; ++c) mine[c] = a.primitives->at[c].data();
  const std::uint32_t* others[corners_b];
  for (std::size_t d = 0; d < corners_b; ++d) others[d] = b.primitives->at[d].data();
  const PairLists lists = found;
  const std::size_t size = overlapping_codes<corners_a, corners_b>(a, b, pairs, lists[0]);
  for (std::size_t n = 0; n < size; ++n) {
    const std::uint32_t code = lists[0][n];
    const std::size_t p = Code::pair_of(code);
    const std::size_t i = pairs.first[p] * block_size + Code::lane_of_first(code);
    const std::size_t j = pairs.second[p] * block_size + Code::lane_of_second(code);
    for (std::size_t c = 0; c < corners_a; ++c) lists[c][n] = mine[c][i];
    for (std::size_t d = 0; d < corners_b; ++d) lists[corners_a + d][n] = others[d][j];
  }
  return size;
}

std::size_t overlapping(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, const PairLists& found) {
  if (a.primitives == nullptr) return overlapping_lanes(a, b, pairs, found);
  if (a.primitives->corner_count == 1) return overlapping_primitives<1, 3>(a, b, pairs, found);
  return overlapping_primitives<2, 2>(a, b, pairs, found);
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
