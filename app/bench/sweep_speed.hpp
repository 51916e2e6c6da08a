#pragma once

#include <string>
#include <vector>

#include "sim/garment.hpp"

namespace taut::app {

/// The speed of one constraint sweep of `bounded` with one vector unit, on one core. An engine's rate over
/// whole frames is lower: the rest of the time goes into forces and other work of a frame.
struct SweepSpeed {
  std::string unit;            ///< as in the key `solver.vector_unit`, such as "avx2"
  double springs_per_s = 0.0;  ///< per second of processor time
};

/// Measures the sweep over the garment's bounded springs, for each vector unit of this processor, narrowest
/// first. Each result is the fastest of several short measurements. Takes some tenths of a second.
std::vector<SweepSpeed> measure_sweep_speeds(const sim::Garment& garment);

}  // namespace taut::app
