#pragma once

#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim::bounded {

/// Smaller triangles have no normal the wind could push along.
inline constexpr float smallest_doubled_area_m2 = 1e-20F;

/// On any processor.
const Kernels& emulated_kernels();

/// Null where neither the compiler nor this processor has the unit.
const Kernels* vector_kernels(VectorUnit unit);

}  // namespace taut::sim::bounded
