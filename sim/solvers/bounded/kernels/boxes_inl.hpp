// Kernels that find overlapping boxes, for the target being compiled. The file is included once per target, so its
// include guard is of another kind.
#if defined(TAUT_BOXES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_BOXES_INL
#undef TAUT_BOXES_INL
#else
#define TAUT_BOXES_INL
#endif

#include <algorithm>
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

HWY_INLINE Boxes load_boxes(const BoxBlock& block, std::size_t k) {
  return {load_lanes(block.low, k), load_lanes(block.high, k)};
}

HWY_INLINE std::uint32_t mask_bits(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Floats(), mask, bytes);
  const std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8;
  return bits & ((1U << lanes) - 1U);
}

HWY_INLINE Triple lesser(const Triple& p, const Triple& q) {
  return {hn::Min(p.x, q.x), hn::Min(p.y, q.y), hn::Min(p.z, q.z)};
}
HWY_INLINE Triple greater(const Triple& p, const Triple& q) {
  return {hn::Max(p.x, q.x), hn::Max(p.y, q.y), hn::Max(p.z, q.z)};
}
HWY_INLINE Triple to_triple(const Four& m) { return {m.a, m.b, m.c}; }

HWY_INLINE Boxes swept_boxes(const MovingRows& rows, const std::uint32_t* at) {
  const Triple begin = as_coordinates(load_rows(as_floats(rows.positions), at));
  const Four way = transpose(load_rows(as_floats(rows.motions), at));
  const Triple end = begin + to_triple(way);
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

/// Returns a mask of the lanes from `first` on that are below `count`.
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
    Boxes reach = swept_boxes(rows, &primitives.at[0][lane]);
    for (std::size_t corner = 1; corner < primitives.corner_count; ++corner) {
      reach = around(reach, swept_boxes(rows, &primitives.at[corner][lane]));
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

using Shorts = hn::CappedTag<std::int16_t, block_size>;
using ShortMask = hn::Mask<Shorts>;
constexpr std::size_t short_lanes = hn::MaxLanes(Shorts());

HWY_INLINE std::uint32_t mask_bits(ShortMask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Shorts(), mask, bytes);
  const std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8;
  return bits & ((1U << short_lanes) - 1U);
}

/// Rounds the coordinates of a block; the infinite coordinates of empty boxes get the highest number.
HWY_INLINE void round_lanes(const std::array<float, block_size>& values, float origin, float per_m,
                            std::array<std::int16_t, block_size>& rounded) {
  constexpr float max_grid_number = std::numeric_limits<std::int16_t>::max();
  const Floats f;
  const hn::Rebind<std::int32_t, Floats> whole;
  const hn::Rebind<std::int16_t, Floats> half;
  for (std::size_t k = 0; k < block_size; k += lanes) {
    const V value = hn::Load(f, &values[k]);
    const V scaled = hn::Mul(hn::Sub(value, hn::Set(f, origin)), hn::Set(f, per_m));
    const V within = hn::Min(hn::Max(scaled, hn::Set(f, -max_grid_number)), hn::Set(f, max_grid_number - 1.0F));
    const Mask is_some = hn::Le(value, hn::Set(f, std::numeric_limits<float>::max()));
    const auto number = hn::ConvertTo(whole, hn::IfThenElse(is_some, within, hn::Set(f, max_grid_number)));
    hn::Store(hn::DemoteTo(half, number), half, &rounded[k]);
  }
}

void round_boxes(const BoxBlock* boxes, std::size_t begin, std::size_t end, const BoxGrid& grid,
                 RoundedBoxes* rounded) {
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      round_lanes(boxes[b].low[axis], grid.origin[axis], grid.per_m[axis], rounded[b].low[axis]);
      round_lanes(boxes[b].high[axis], grid.origin[axis], grid.per_m[axis], rounded[b].high[axis]);
    }
  }
}

struct RoundedBox {
  std::array<std::int16_t, 3> low, high;
};

HWY_INLINE RoundedBox box_in(const RoundedBoxes& boxes, std::size_t lane) {
  return {{boxes.low[0][lane], boxes.low[1][lane], boxes.low[2][lane]},
          {boxes.high[0][lane], boxes.high[1][lane], boxes.high[2][lane]}};
}

HWY_INLINE RoundedBox within_both(const RoundedBox& p, const RoundedBox& q) {
  RoundedBox both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.low[axis] = std::max(p.low[axis], q.low[axis]);
    both.high[axis] = std::min(p.high[axis], q.high[axis]);
  }
  return both;
}

/// Returns as bits which boxes of a block may overlap a box.
HWY_INLINE std::uint32_t overlapping_bits(const RoundedBox& box, const RoundedBoxes& boxes) {
  const Shorts s;
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < block_size; k += short_lanes) {
    const auto apart = [&](std::size_t axis) {
      return hn::Or(hn::Gt(hn::Load(s, &boxes.low[axis][k]), hn::Set(s, box.high[axis])),
                    hn::Gt(hn::Set(s, box.low[axis]), hn::Load(s, &boxes.high[axis][k])));
    };
    bits |= mask_bits(hn::Not(hn::Or(hn::Or(apart(0), apart(1)), apart(2)))) << k;
  }
  return bits;
}

/// A pair of lanes of a pair of blocks as one number, as stores limit the speed of this search.
struct LanePairCode {
  static HWY_INLINE std::uint32_t of(std::size_t pair, std::size_t lanes_of_pair) {
    return static_cast<std::uint32_t>(pair * block_size * block_size + lanes_of_pair);
  }
  static HWY_INLINE std::size_t pair_of(std::uint32_t code) { return code / (block_size * block_size); }
  static HWY_INLINE std::size_t lane_of_first(std::uint32_t code) { return code / block_size % block_size; }
  static HWY_INLINE std::size_t lane_of_second(std::uint32_t code) { return code % block_size; }
};

/// Sets of lanes of another block for each lane, as bits of a few words.
struct LaneBits {
  static constexpr std::size_t word_bits = 64;
  alignas(32) LanePairs lane_sets = {};

  HWY_INLINE std::uint64_t word(std::size_t w) const {
    constexpr std::size_t per_word = word_bits / block_size;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < per_word; ++k) bits |= std::uint64_t{lane_sets[w * per_word + k]} << (k * block_size);
    return bits;
  }
};

/// Lists the pairs of lanes with overlapping boxes. Boxes overlap only in the intersection of the boxes around their
/// blocks.
std::size_t overlapping_codes(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, std::uint32_t* codes) {
  static constexpr LanePairs none = {};
  std::size_t size = 0;
  for (std::size_t p = 0; p < pairs.count; ++p) {
    const std::uint32_t block_a = pairs.first[p];
    const std::uint32_t block_b = pairs.second[p];
    const RoundedBoxes& mine = a.boxes[block_a];
    const RoundedBoxes& others = b.boxes[block_b];
    const RoundedBox both = within_both(box_in(a.around[block_a / block_size], block_a % block_size),
                                        box_in(b.around[block_b / block_size], block_b % block_size));
    std::uint32_t reaching = overlapping_bits(both, mine);
    if (reaching == 0) continue;
    const LanePairs& left_out = pairs.excluded == nullptr ? none : pairs.excluded->between(block_a, block_b);
    const bool is_same = &mine == &others;
    LaneBits hits;
    for (; reaching != 0; reaching &= reaching - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(reaching));
      // Earlier lanes of the same block have been compared with this one.
      const std::uint32_t before = is_same ? (1U << lane) - 1U : 0U;
      hits.lane_sets[lane] = static_cast<std::uint16_t>(overlapping_bits(box_in(mine, lane), others) &
                                                        ~(before | std::uint32_t{left_out[lane]}));
    }
    for (std::size_t w = 0; w < block_size * block_size / LaneBits::word_bits; ++w) {
      for (std::uint64_t bits = hits.word(w); bits != 0; bits &= bits - 1) {
        codes[size++] = LanePairCode::of(p, w * LaneBits::word_bits + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }
  return size;
}

std::size_t overlapping_lanes(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs, const PairLists& found) {
  const std::size_t size = overlapping_codes(a, b, pairs, found[0]);
  for (std::size_t n = 0; n < size; ++n) {
    const std::uint32_t code = found[0][n];
    const std::size_t p = LanePairCode::pair_of(code);
    found[1][n] = static_cast<std::uint32_t>(pairs.second[p] * block_size + LanePairCode::lane_of_second(code));
    found[0][n] = static_cast<std::uint32_t>(pairs.first[p] * block_size + LanePairCode::lane_of_first(code));
  }
  return size;
}

/// Lists the overlapping primitives without a common vertex.
template <std::size_t corners_a, std::size_t corners_b>
std::size_t overlapping_primitives(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs,
                                   const PairLists& found) {
  const std::uint32_t* mine[corners_a];
  for (std::size_t c = 0; c < corners_a; ++c) mine[c] = a.primitives->at[c].data();
  const std::uint32_t* others[corners_b];
  for (std::size_t d = 0; d < corners_b; ++d) others[d] = b.primitives->at[d].data();
  const PairLists lists = found;
  const std::size_t size = overlapping_codes(a, b, pairs, lists[0]);
  std::size_t kept_count = 0;
  for (std::size_t n = 0; n < size; ++n) {
    const std::uint32_t code = lists[0][n];
    const std::size_t p = LanePairCode::pair_of(code);
    const std::size_t i = pairs.first[p] * block_size + LanePairCode::lane_of_first(code);
    const std::size_t j = pairs.second[p] * block_size + LanePairCode::lane_of_second(code);
    bool shares = false;
    for (std::size_t d = 0; d < corners_b; ++d) {
      lists[corners_a + d][kept_count] = others[d][j];
      for (std::size_t c = 0; c < corners_a; ++c) shares |= mine[c][i] == others[d][j];
    }
    for (std::size_t c = 0; c < corners_a; ++c) lists[c][kept_count] = mine[c][i];
    kept_count += shares ? 0 : 1;
  }
  return kept_count;
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
