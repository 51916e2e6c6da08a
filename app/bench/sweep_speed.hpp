#pragma once

#include <string>
#include <vector>

#include "sim/garment.hpp"

namespace taut::app {

/// How many springs one sweep of the constraint of `bounded` corrects in a second of processor time, one
/// core, with one vector unit: what an engine lacks to it goes into forces and into everything else a frame
/// takes.
struct SweepSpeed {
  std::string unit;  ///< as `solver.vector_unit` has it, such as "avx2"
  double springs_per_s = 0.0;
};

/// Of each vector unit the processor has, narrowest first, over the garment's bound springs: the fastest of
/// several short measurements, together some tenths of a second.
std::vector<SweepSpeed> measure_sweep_speeds(const sim::Garment& garment);

}  // namespace taut::app
