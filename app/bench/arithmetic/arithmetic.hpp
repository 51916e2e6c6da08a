#pragma once

#include <string>
#include <vector>

namespace taut::app {

/// How many springs the processor could correct in a second on one core if that were arithmetic alone: the
/// root, the division, the products and sums of eq. (3), measured over springs that share no ends and never
/// leave the innermost cache. What an engine lacks to it goes into fetching and storing ends, into forces and
/// into everything else a frame takes.
struct ArithmeticLimit {
  std::string unit;  ///< such as "AVX2, 8 floats"
  int lanes = 1;
  double springs_per_s = 0.0;
};

/// One for each vector unit the processor has, narrowest first: the fastest of several short measurements,
/// together some tenths of a second.
std::vector<ArithmeticLimit> measure_arithmetic_limits();

}  // namespace taut::app
