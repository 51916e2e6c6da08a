#pragma once

#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim::bounded {

/// The kernels as loops over single springs, triangles and vertices: what those of every vector unit have to
/// give, bit for bit.
const Kernels& scalar_kernels();

}  // namespace taut::sim::bounded
