#pragma once

#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim::bounded {

/// Smallest doubled area of a triangle by which the wind kernel divides, in m^2.
inline constexpr float min_doubled_area_m2 = 1e-20F;

/// Smallest divisor of the sine of the angle of incidence. Slower air presses as if along the cloth.
inline constexpr float min_air_speed_m_per_s = 1e-15F;

/// Returns the kernels in ordinary instructions, for any processor.
const Kernels& emulated_kernels();

/// Returns the kernels for a unit; null if the compiler or this processor does not support it.
const Kernels* vector_kernels(VectorUnit unit);

}  // namespace taut::sim::bounded
