#include "app/bench/arithmetic/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/base/stopwatch.hpp"
#include "app/bench/arithmetic/kernels.hpp"

namespace taut::app {
namespace {

double springs_per_s(int springs_per_repeat, double (*run)(int repeats)) {
  constexpr int repeats = 20000, measurements = 15;
  double shortest_ms = 1e9;
  double sum = 0.0;
  for (int i = 0; i < measurements; ++i) {
    const ProcessorStopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    sum += run(repeats);
    shortest_ms = std::min(shortest_ms, clock.elapsed_ms());
  }
  if (!std::isfinite(sum)) {
    throw std::logic_error("the springs of the arithmetic measurement flew apart");
  }
  return 1e3 * springs_per_repeat * repeats / shortest_ms;
}

ArithmeticLimit limit_of(const std::string& unit, int lanes, const SpringKernel& kernel) {
  return {unit, lanes, springs_per_s(kernel.springs_per_repeat, kernel.run),
          springs_per_s(kernel.springs_per_repeat, kernel.run_without_root)};
}

}  // namespace

std::vector<ArithmeticLimit> measure_arithmetic_limits() {
  std::vector<ArithmeticLimit> limits = {limit_of("1 double", 1, spring_kernel_1()),
                                         limit_of("4 floats", 4, spring_kernel_4())};
#ifdef __x86_64__
  limits[1].unit = "SSE2, 4 floats";
  if (__builtin_cpu_supports("avx2")) {
    limits.push_back(limit_of("AVX2, 8 floats", 8, spring_kernel_8()));
  }
  if (__builtin_cpu_supports("avx512f")) {
    limits.push_back(limit_of("AVX-512, 16 floats", 16, spring_kernel_16()));
  }
#endif
  return limits;
}

}  // namespace taut::app
