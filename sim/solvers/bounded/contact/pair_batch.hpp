#pragma once

#include "sim/solvers/bounded/contact/near_pair.hpp"
#include "sim/solvers/bounded/kernels/contact_kernels.hpp"

namespace taut::sim::bounded {

/// Gathers pairs of a vertex and a triangle, and pairs of edges, until a block of one kind is full.
class PairBatches {
 public:
  struct Batch {
    Index first_count;  ///< see NearPair
    PairBlock block = {};
    std::array<std::size_t, block_size> index = {};  ///< see add()
    std::size_t count = 0;
  };

  /// Adds a pair with an index of the caller's. Calls take(batch) when its batch is full.
  template <typename Take> void add(const NearPair& near, std::size_t index, float thickness_m, const Take& take) {
    assert(near.first_count == 1 || near.first_count == 2);
    Batch& batch = batches_[near.first_count - 1];
    for (std::size_t k = 0; k < 4; ++k) batch.block.at[k][batch.count] = 4 * near.rows[k];
    batch.block.thickness[batch.count] = thickness_m;
    batch.index[batch.count] = index;
    if (++batch.count == block_size) flush(batch, take);
  }

  /// Calls take(batch) for the batches that are left.
  template <typename Take> void end(const Take& take) {
    for (Batch& batch : batches_) {
      if (batch.count > 0) flush(batch, take);
    }
  }

 private:
  template <typename Take> static void flush(Batch& batch, const Take& take) {
    take(batch);
    batch.count = 0;
  }

  std::array<Batch, 2> batches_ = {Batch{1}, Batch{2}};
};

}  // namespace taut::sim::bounded
