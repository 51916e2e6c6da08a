#pragma once

#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim::bounded {

/// The kernels as loops over single springs, triangles and vertices. The kernels of every vector unit must
/// give the same bits. Kernels of contact are not among them: a search through all pairs is held against them.
const Kernels& scalar_kernels();

}  // namespace taut::sim::bounded
