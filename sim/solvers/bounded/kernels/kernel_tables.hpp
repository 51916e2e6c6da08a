#pragma once

#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim::bounded {

/// The wind's kernel uses at least this as twice the area of a triangle, in m^2, when it divides by it.
inline constexpr float smallest_doubled_area_m2 = 1e-20F;

/// The kernels in ordinary instructions, which run on any processor.
const Kernels& emulated_kernels();

/// Returns null if the compiler or this processor does not support the unit.
const Kernels* vector_kernels(VectorUnit unit);

}  // namespace taut::sim::bounded
