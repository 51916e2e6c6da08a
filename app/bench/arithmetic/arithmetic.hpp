#pragma once

#include <string>
#include <vector>

namespace taut::app {

/// How many springs the processor could correct in a second on one core if that were arithmetic alone: the
/// division, the products, the sums and perhaps the root of eq. (3), measured over springs that share no ends
/// and never leave the innermost cache. What an engine lacks to it goes into fetching and storing ends, into
/// forces and into everything else a frame takes.
struct ArithmeticLimit {
  std::string unit;  ///< such as "AVX2, 8 floats"
  int lanes = 1;
  double springs_per_s = 0.0;           ///< a root and a division for each, as eq. (3) has it
  double rootless_springs_per_s = 0.0;  ///< a division alone, as `bounded` and Bullet have it
};

/// One for each vector unit the processor has, narrowest first: the fastest of several short measurements,
/// together some tenths of a second.
std::vector<ArithmeticLimit> measure_arithmetic_limits();

}  // namespace taut::app
