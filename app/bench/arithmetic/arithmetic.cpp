#include "app/bench/arithmetic/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/bench/arithmetic/kernels.hpp"
#include "app/bench/cpu_clock.hpp"

namespace taut::app {
namespace {

double springs_per_s(const SpringKernel& kernel) {
  constexpr int repeats = 20000, measurements = 15;
  double shortest_ms = 1e9;
  double sum = 0.0;
  for (int i = 0; i < measurements; ++i) {
    const CpuClock clock;
    sum += kernel.run(repeats);
    shortest_ms = std::min(shortest_ms, clock.elapsed_ms());
  }
  if (!std::isfinite(sum)) {
    throw std::logic_error("the springs of the arithmetic measurement flew apart");
  }
  return 1e3 * kernel.springs_per_repeat * repeats / shortest_ms;
}

}  // namespace

std::vector<ArithmeticLimit> measure_arithmetic_limits() {
  std::vector<ArithmeticLimit> limits = {{"1 double", 1, springs_per_s(spring_kernel_1())},
                                         {"4 floats", 4, springs_per_s(spring_kernel_4())}};
#ifdef __x86_64__
  limits[1].unit = "SSE2, 4 floats";
  if (__builtin_cpu_supports("avx2")) {
    limits.push_back({"AVX2, 8 floats", 8, springs_per_s(spring_kernel_8())});
  }
  if (__builtin_cpu_supports("avx512f")) {
    limits.push_back({"AVX-512, 16 floats", 16, springs_per_s(spring_kernel_16())});
  }
#endif
  return limits;
}

}  // namespace taut::app
