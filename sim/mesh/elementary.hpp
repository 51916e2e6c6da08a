#pragma once

namespace taut::sim {

// Elementary functions of plain additions, products and quotients. Those of a C library give other last bits
// on a processor without fused multiply-add, and with them another state.

/// sin(2 pi `turns`), to 4e-16.
double sine_of_turns(double turns);

/// e^x to a relative 1e-15, for |x| < 700.
double exponential(double x);

}  // namespace taut::sim
