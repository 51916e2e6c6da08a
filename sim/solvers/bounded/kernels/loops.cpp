#include "sim/solvers/bounded/kernels/loops.hpp"

namespace taut::sim::bounded {
namespace {

/// Some microseconds of work: less is done sooner than another thread has noticed it.
constexpr std::size_t least_blocks = 48;

}  // namespace

void Loops::predict(const Prediction& prediction, const Tether* tethers, const Row* accelerations,
                    const Rows& current, Rows& previous) {
  team_.split(0, current.size() / block_size, 2 * least_rows / block_size, [&](std::size_t b, std::size_t e) {
    kernels_.predict(b * block_size, e * block_size, prediction, tethers, accelerations, current.data(),
                     previous.data());
  });
}

void Loops::start_springs(const StartRows& start, SpringLanes& springs) {
  team_.split(0, springs.block_count(), least_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.start_springs(start, b, e, springs); });
}

void Loops::sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Row* rows) {
  team_.split(begin, end, least_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.sweep(springs, b, e, rows); });
}

void Loops::shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
                    float relaxation, Row* rows) {
  team_.split(0, blocks.size(), least_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.shorten(springs, blocks.subspan(b, e - b), squared_bound, relaxation, rows);
  });
}

void Loops::largest_ratios(const SpringLanes& springs, const Row* rows, float* squared_ratios) {
  team_.split(0, springs.block_count(), least_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.largest_ratios(springs, b, e, rows, squared_ratios);
  });
}

void Loops::wind(const TriangleLanes& triangles, const AirFlow& air, const Row* start, const Row* current,
                 const Row* previous, Row* corner_forces) {
  team_.split(0, triangles.lane_count() / block_size, least_blocks, [&](std::size_t b, std::size_t e) {
    kernels_.wind(triangles, air, b * block_size, e * block_size, start, current, previous, corner_forces);
  });
}

void Loops::add_product(const SlicedMatrix& matrix, const Row* positions, Row* result) {
  team_.split(0, matrix.slice_count(), least_blocks,
              [&](std::size_t b, std::size_t e) { kernels_.add_product(matrix, b, e, positions, result); });
}

}  // namespace taut::sim::bounded
