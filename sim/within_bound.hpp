#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/state.hpp"

namespace taut::sim {

/// Moves the cloth, with its velocity, to the nearest shape found in which no structural or shear spring is
/// longer than `bounded` allows by these settings; not at all where the settings promise no bound, or the
/// shape keeps it already. Pinned vertices stay, so that where pins hold the cloth too far apart the bound
/// cannot be kept everywhere.
void move_within_bound(const Garment& garment, const SolverSettings& settings, State& state);

}  // namespace taut::sim
