#pragma once

namespace taut::sim {

// Elementary functions made of additions, products and quotients only. Those of the C library give other last
// bits on processors without fused multiply-add, and so another state.

/// sin(2 pi `turns`) with an error of at most 4e-16.
double sine_of_turns(double turns);
/// cos(2 pi `turns`) with the same error.
double cosine_of_turns(double turns);

/// e^x with a relative error of at most 1e-15. Requires |x| < 700.
double exponential(double x);

}  // namespace taut::sim
