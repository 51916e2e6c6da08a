#pragma once

#include "prelude.hpp"

namespace taut::sim {

// Elementary functions made of additions, products and quotients only. The C library's results differ in their last
// bits on processors without fused multiply-add, which would change the state.

/// Returns sin(2 pi `turns`) with an error of at most 4e-16.
double sine_of_turns(double turns);
/// Returns cos(2 pi `turns`) with an error of at most 4e-16.
double cosine_of_turns(double turns);
/// Returns the angle from the first axis to (x, y), in turns, -1/2 to 1/2, with an error of at most 4e-16; 0
/// for (0, 0). Requires that the squares of x and y are finite.
double atan2_turns(double y, double x);

/// Returns e^x with a relative error of at most 1e-15. Requires |x| < 700.
double exponential(double x);

}  // namespace taut::sim
