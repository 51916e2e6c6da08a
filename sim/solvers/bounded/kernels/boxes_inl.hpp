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

/// Returns which boxes of a block overlap the one box that `box` repeats.
HWY_INLINE std::uint32_t overlapping_bits(const Boxes& box, const BoxBlock& block) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < block_size; k += lanes) {
    bits |= bits_of(overlap(box, load_boxes(block, k))) << k;
  }
  return bits;
}

HWY_INLINE Triple lesser(const Triple& p, const Triple& q) {
  return {hn::Min(p.x, q.x), hn::Min(p.y, q.y), hn::Min(p.z, q.z)};
}
HWY_INLINE Triple greater(const Triple& p, const Triple& q) {
  return {hn::Max(p.x, q.x), hn::Max(p.y, q.y), hn::Max(p.z, q.z)};
}
HWY_INLINE Triple coordinates_of(const Four& m) {
  return {m.a, m.b, m.c};
}

HWY_INLINE Boxes reach_of(const MovingRows& rows, const std::uint32_t* at) {
  const Triple begin = as_coordinates(load_rows(floats_of(rows.places), at));
  const Four way = transposed(load_rows(floats_of(rows.ways), at));
  const Triple end = begin + coordinates_of(way);
  const Triple radius = {way.d, way.d, way.d};
  return {lesser(begin, end) - radius, greater(begin, end) + radius};
}

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
  return hn::RebindMask(Floats(), hn::Lt(hn::Iota(u, static_cast<std::uint32_t>(first)),
                                         hn::Set(u, static_cast<std::uint32_t>(count))));
}

void enclose(const PrimitiveLanes& primitives, std::size_t begin, std::size_t end, const MovingRows& rows,
             BoxBlock* boxes) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  for (std::size_t lane = begin * block_size; lane < end * block_size; lane += lanes) {
    Boxes reach = reach_of(rows, &primitives.at[0][lane]);
    for (std::size_t corner = 1; corner < primitives.corner_count; ++corner) {
      const Boxes other = reach_of(rows, &primitives.at[corner][lane]);
      reach = {lesser(reach.low, other.low), greater(reach.high, other.high)};
    }
    BoxBlock& block = boxes[lane / block_size];
    const Mask is_some = lanes_below(lane, primitives.count);
    store_or_empty(is_some, reach.low, infinite, lane % block_size, block.low);
    store_or_empty(is_some, reach.high, -infinite, lane % block_size, block.high);
  }
}

void enclose_blocks(const BoxBlock* boxes, std::size_t begin, std::size_t end, BoxBlock* around) {
  const Floats f;
  for (std::size_t b = begin; b < end; ++b) {
    Boxes all = load_boxes(boxes[b], 0);
    for (std::size_t k = lanes; k < block_size; k += lanes) {
      const Boxes others = load_boxes(boxes[b], k);
      all = {lesser(all.low, others.low), greater(all.high, others.high)};
    }
    auto& [low, high] = around[b / block_size];
    const std::size_t lane = b % block_size;
    low[0][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.x));
    low[1][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.y));
    low[2][lane] = hn::GetLane(hn::MinOfLanes(f, all.low.z));
    high[0][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.x));
    high[1][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.y));
    high[2][lane] = hn::GetLane(hn::MaxOfLanes(f, all.high.z));
  }
}

/// Calls found(i, j) for lanes of two blocks whose boxes overlap, unless bit j % block_size of excluded(i) is
/// set. Bits are gone through for four lanes at a time, as the processor guesses wrong where they end.
template <typename Excluded, typename Found>
HWY_INLINE void for_overlapping(const BoxLevel& a, const BoxLevel& b, std::size_t block_a,
                                std::size_t block_b, const Excluded& excluded, const Found& found) {
  const BoxBlock& mine = a.boxes[block_a];
  const BoxBlock& others = b.boxes[block_b];
  const Boxes all_others = repeat_box(b.around[block_b / block_size], block_b % block_size);
  std::uint32_t reaching = overlapping_bits(all_others, mine);
  for (std::size_t first = 0; reaching != 0; first += 4, reaching >>= 4) {
    std::uint64_t bits_of_four = 0;
    for (std::uint32_t four = reaching & 15U; four != 0; four &= four - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(four));
      const std::size_t i = first + lane;
      std::uint32_t bits =
          overlapping_bits(repeat_box(mine, i), others) & ~excluded(block_a * block_size + i);
      if (&mine == &others) {
        bits &= ~0U << i;
      }
      bits_of_four |= std::uint64_t{bits} << (block_size * lane);
    }
    for (; bits_of_four != 0; bits_of_four &= bits_of_four - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(bits_of_four));
      found(block_a * block_size + first + bit / block_size, block_b * block_size + bit % block_size);
    }
  }
}

std::size_t overlapping_lanes(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs,
                              const PairLists& found) {
  const auto none = [](std::size_t) HWY_ATTR { return 0U; };
  std::size_t size = 0;
  for (std::size_t p = 0; p < pairs.count; ++p) {
    for_overlapping(a, b, pairs.first[p], pairs.second[p], none, [&](std::size_t i, std::size_t j) HWY_ATTR {
      found[0][size] = static_cast<std::uint32_t>(i);
      found[1][size] = static_cast<std::uint32_t>(j);
      ++size;
    });
  }
  return size;
}

/// Returns which primitives of a block share a row with that in lane i.
template <std::size_t corners_a, std::size_t corners_b>
HWY_INLINE std::uint32_t sharing_bits(const PrimitiveLanes& a, std::size_t i, const PrimitiveLanes& b,
                                      std::size_t block) {
  const Integers u;
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < block_size; k += lanes) {
    const std::size_t j = block * block_size + k;
    auto shares = hn::Eq(hn::Set(u, a.at[0][i]), hn::Load(u, &b.at[0][j]));
    for (std::size_t c = 0; c < corners_a; ++c) {
      for (std::size_t d = c == 0 ? 1 : 0; d < corners_b; ++d) {
        shares = hn::Or(shares, hn::Eq(hn::Set(u, a.at[c][i]), hn::Load(u, &b.at[d][j])));
      }
    }
    bits |= bits_of(hn::RebindMask(Floats(), shares)) << k;
  }
  return bits;
}

template <std::size_t corners_a, std::size_t corners_b>
std::size_t overlapping_primitives(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs,
                                   const PairLists& found) {
  const PrimitiveLanes& mine = *a.primitives;
  const PrimitiveLanes& others = *b.primitives;
  std::size_t size = 0;
  for (std::size_t p = 0; p < pairs.count; ++p) {
    const auto sharing = [&](std::size_t i) HWY_ATTR {
      return sharing_bits<corners_a, corners_b>(mine, i, others, pairs.second[p]);
    };
    for_overlapping(a, b, pairs.first[p], pairs.second[p], sharing,
                    [&](std::size_t i, std::size_t j) HWY_ATTR {
                      for (std::size_t c = 0; c < corners_a; ++c) {
                        found[c][size] = mine.at[c][i];
                      }
                      for (std::size_t d = 0; d < corners_b; ++d) {
                        found[corners_a + d][size] = others.at[d][j];
                      }
                      ++size;
                    });
  }
  return size;
}

std::size_t overlapping(const BoxLevel& a, const BoxLevel& b, const BlockPairs& pairs,
                        const PairLists& found) {
  if (a.primitives == nullptr) {
    return overlapping_lanes(a, b, pairs, found);
  }
  if (a.primitives->corner_count == 1) {
    return overlapping_primitives<1, 3>(a, b, pairs, found);
  }
  return overlapping_primitives<2, 2>(a, b, pairs, found);
}

#endif

}  // namespace
}  // namespace taut::sim::bounded::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
