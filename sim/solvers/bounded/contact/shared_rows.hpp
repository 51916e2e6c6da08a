#pragma once

#include "sim/solvers/bounded/kernels/contact_kernels.hpp"

namespace taut::sim::bounded {

/// Returns which primitives of two lists share a vertex: the boxes of such neighbours always overlap.
BlockLanePairs shared_rows(const PrimitiveLanes& a, const PrimitiveLanes& b);

}  // namespace taut::sim::bounded
