#pragma once

#include <span>

#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/thread_pool.hpp"

namespace taut::sim::bounded {

/// The functions of Kernels, divided among the threads of a pool.
class ParallelKernels {
 public:
  /// Smallest number of blocks, or of pairs that may touch, for one thread: a microsecond of work or more. Less is done
  /// sooner than another thread notices it.
  static constexpr std::size_t min_blocks = 16;
  static constexpr std::size_t min_pairs = 64;

  ParallelKernels(const Kernels& kernels, int threads) : kernels_(kernels), pool_(threads) {}

  /// See ThreadPool.
  void share(bool is_shared) { pool_.share(is_shared); }
  PoolWork take_work() { return pool_.take_work(); }

  /// Predicts all vertices. `tethers` may be null.
  void predict(const Prediction& prediction, const Tether* tethers, const Float4* accelerations,
               const Float4Array& current, Float4Array& previous);

  void start(const StartRows& start, SpringLanes& springs);
  void start(const StartRows& start, SurfaceLanes& triangles);

  void sweep(const SpringLanes& springs, const BlockRange& range, Float4* rows);
  void sweep(const SurfaceLanes& triangles, const BlockRange& range, SurfaceSums* sums, Float4* rows);

  /// All blocks must be of one colour.
  void shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound, float relaxation,
               Float4* rows);
  void shorten(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks, float squared_bound,
               float relaxation, Float4* rows);

  void find_max_ratios(const SpringLanes& springs, const Float4* rows, float* squared_ratios);
  void find_max_ratios(const SurfaceLanes& triangles, const Float4* rows, float* squared_ratios);
  void wind(const TriangleLanes& triangles, const AirFlow& air, const Float4* start, const Float4* current,
            const Float4* previous, const Float4* opposed, Float4* corner_forces);
  void add_product(const SlicedMatrix& matrix, const Float4* positions, Float4* result);

  const ContactKernels& contact() const { return kernels_.contact; }
  void enclose(const PrimitiveLanes& primitives, const MovingRows& rows, BoxBlock* boxes);
  void round_boxes(const Lanes<BoxBlock>& boxes, const BoxGrid& grid, RoundedBoxes* rounded);
  void enclose_blocks(const BoxBlock* boxes, std::size_t count, BoxBlock* around);

  /// Calls part(b, e) for ranges that together cover [begin, end), each of at least `least`. See ThreadPool.
  template <typename Part> void split(std::size_t begin, std::size_t end, std::size_t least, const Part& part) {
    pool_.split(begin, end, least, part);
  }

  /// Calls part(b, e) for ranges of solver indices that together cover [begin, end). The work for one vertex must not
  /// depend on others.
  template <typename Part> void for_rows(std::size_t begin, std::size_t end, const Part& part) {
    pool_.split(begin, end, min_blocks * block_size, part);
  }

 private:
  const Kernels& kernels_;
  ThreadPool pool_;
};

}  // namespace taut::sim::bounded
