#pragma once

#include "sim/solvers/bounded/kernels/contact_kernels.hpp"

namespace taut::sim::bounded {

/// Which primitives of the blocks of two lists share a row: neighbours, whose boxes always overlap.
class SharedRows {
 public:
  SharedRows(const PrimitiveLanes& a, const PrimitiveLanes& b);

  /// Returns the lanes of a block of `b` that share a row with each lane of a block of `a`.
  const LanePairs& between(std::uint32_t block_a, std::uint32_t block_b) const;

 private:
  std::vector<std::uint32_t> begin_ = {0};  ///< by block of `a`, of its entries in the others
  std::vector<std::uint32_t> blocks_;       ///< of `b`, in their order
  std::vector<LanePairs> lanes_;
};

}  // namespace taut::sim::bounded
