#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

#include <algorithm>

namespace taut::sim::bounded {
void ParallelKernels::predict(const Prediction& prediction, const Tether* tethers, const Float4* accelerations,
                              const Float4Array& current, Float4Array& previous) {
  assert(current.size() == previous.size());
  pool_.split(0, current.size() / block_size, min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.predict(b * block_size, e * block_size, prediction, tethers, accelerations, current.data(),
                     previous.data());
  });
}

void ParallelKernels::start(const StartRows& start, SpringLanes& springs) {
  pool_.split(0, springs.block_count(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.start_springs(start, b, e, springs); });
}

void ParallelKernels::start(const StartRows& start, SurfaceLanes& triangles) {
  pool_.split(0, triangles.block_count(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.start_surface(start, b, e, triangles); });
}

void ParallelKernels::sweep(const SpringLanes& springs, const BlockRange& range, Float4* rows) {
  pool_.split(range.begin, range.end, min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.sweep(springs, b, e, rows); });
}

void ParallelKernels::sweep(const SurfaceLanes& triangles, const BlockRange& range, SurfaceSums* sums, Float4* rows) {
  pool_.split(range.begin, range.end, min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.sweep_surface(triangles, {static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(e), range.is_repeat},
                           sums, rows);
  });
}

void ParallelKernels::shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
                              float relaxation, Float4* rows) {
  pool_.split(0, blocks.size(), min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.shorten(springs, blocks.subspan(b, e - b), squared_bound, relaxation, rows);
  });
}

void ParallelKernels::shorten(const SurfaceLanes& triangles, std::span<const std::uint32_t> blocks, float squared_bound,
                              float relaxation, Float4* rows) {
  pool_.split(0, blocks.size(), min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.shorten_surface(triangles, blocks.subspan(b, e - b), squared_bound, relaxation, rows);
  });
}

void ParallelKernels::find_max_ratios(const SpringLanes& springs, const Float4* rows, float* squared_ratios) {
  pool_.split(0, springs.block_count(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.find_max_ratios(springs, b, e, rows, squared_ratios); });
}

void ParallelKernels::find_max_ratios(const SurfaceLanes& triangles, const Float4* rows, float* squared_ratios) {
  pool_.split(0, triangles.block_count(), min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.find_max_surface_ratios(triangles, b, e, rows, squared_ratios);
  });
}

void ParallelKernels::wind(const TriangleLanes& triangles, const AirFlow& air, const Float4* start,
                           const Float4* current, const Float4* previous, const Float4* opposed,
                           Float4* corner_forces) {
  pool_.split(0, triangles.lane_count() / block_size, min_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.wind(triangles, air, b * block_size, e * block_size, start, current, previous, opposed, corner_forces);
  });
}

void ParallelKernels::add_product(const SlicedMatrix& matrix, const Float4* positions, Float4* result) {
  pool_.split(0, matrix.slice_count(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.add_product(matrix, b, e, positions, result); });
}

void ParallelKernels::enclose(const PrimitiveLanes& primitives, const MovingRows& rows, BoxBlock* boxes) {
  pool_.split(0, primitives.block_count(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.contact.enclose(primitives, b, e, rows, boxes); });
}

void ParallelKernels::round_boxes(const Lanes<BoxBlock>& boxes, const BoxGrid& grid, RoundedBoxes* rounded) {
  pool_.split(0, boxes.size(), min_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.contact.round_boxes(boxes.data(), b, e, grid, rounded); });
}

void ParallelKernels::enclose_blocks(const BoxBlock* boxes, std::size_t count, BoxBlock* around) {
  // Threads write whole blocks of `around`.
  const std::size_t parents = (count + block_size - 1) / block_size;
  pool_.split(0, parents, min_blocks / block_size, [&](std::size_t b, std::size_t e) {
    kernels_.contact.enclose_blocks(boxes, b * block_size, std::min(e * block_size, count), around);
  });
}

}  // namespace taut::sim::bounded
