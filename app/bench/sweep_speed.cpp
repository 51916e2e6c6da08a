#include "app/bench/sweep_speed.hpp"

#include <algorithm>
#include <limits>

#include "app/base/stopwatch.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::app {
namespace {

using namespace sim::bounded;

// The fastest of this many measurements counts. More take longer and hide more of what else the machine does.
constexpr int measurements = 15;
// Springs corrected in one measurement: enough for the clock's resolution.
constexpr std::size_t springs_per_measurement = 1'000'000;

double shortest_ms(const Kernels& kernels, const SpringLanes& springs, std::size_t sweeps,
                   Float4Array& displacements) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < measurements; ++i) {
    const ProcessorStopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
      for (const auto [begin, end, again] : springs.sweep) {
        kernels.sweep(springs, begin, end, displacements.data());
      }
    }
    shortest = std::min(shortest, clock.elapsed_ms());
  }
  return shortest;
}

}  // namespace

std::vector<SweepSpeed> measure_sweep_speeds(const sim::Garment& garment) {
  Layout layout = make_layout(garment, sim::make_pins(garment, {}));
  StartRows start;
  set_start(layout, garment.mesh.positions, start);
  SpringLanes& springs = layout.springs;
  const auto no_springs = std::count(springs.spring.begin(), springs.spring.end(), SpringLanes::no_spring);
  const std::size_t count = springs.lane_count() - static_cast<std::size_t>(no_springs);
  std::vector<SweepSpeed> speeds;
  for (const sim::VectorUnit unit : sim::available_vector_units()) {
    if (unit == sim::VectorUnit::best || count == 0) {
      continue;
    }
    const Kernels& kernels = kernels_for(unit);
    kernels.start_springs(start, 0, springs.block_count(), springs);
    Float4Array displacements(layout.row_count());
    const std::size_t sweeps = 1 + springs_per_measurement / count;
    const double ms = shortest_ms(kernels, springs, sweeps, displacements);
    speeds.push_back({sim::name_of(unit), 1e3 * static_cast<double>(sweeps * count) / ms});
  }
  return speeds;
}

}  // namespace taut::app
