#pragma once

#include <span>

#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/kernels/team.hpp"

namespace taut::sim::bounded {

/// The kernels, each shared among the threads of a team. What each does is said there.
class Loops {
 public:
  Loops(const Kernels& kernels, int threads) : kernels_(kernels), team_(threads) {}

  void share(bool is_shared) { team_.share(is_shared); }
  TeamWork take_work() { return team_.take_work(); }

  /// Of all rows; `tethers` may be null.
  void predict(const Prediction& prediction, const Tether* tethers, const Row* accelerations,
               const Rows& current, Rows& previous);

  void start_springs(const StartRows& start, SpringLanes& springs);

  /// All blocks must be of one colour, here and in `shorten`.
  void sweep(const SpringLanes& springs, std::size_t begin, std::size_t end, Row* rows);
  void shorten(const SpringLanes& springs, std::span<const std::uint32_t> blocks, float squared_bound,
               float relaxation, Row* rows);

  void largest_ratios(const SpringLanes& springs, const Row* rows, float* squared_ratios);
  void wind(const TriangleLanes& triangles, const AirFlow& air, const Row* start, const Row* current,
            const Row* previous, Row* corner_forces);
  void add_product(const SlicedMatrix& matrix, const Row* positions, Row* result);

  /// Calls part(b, e) for stretches of rows that cover [begin, end); what it does for a row must not depend
  /// on what it does for others.
  template <typename Part>
  void for_rows(std::size_t begin, std::size_t end, const Part& part) {
    team_.split(begin, end, least_rows, part);
  }

 private:
  static constexpr std::size_t least_rows = 2048;

  const Kernels& kernels_;
  Team team_;
};

}  // namespace taut::sim::bounded
