#pragma once

#include <functional>

#include "sim/solvers/implicit/system.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/step.hpp"

namespace taut::sim::implicit {

/// Adds what the cloth opposes in the current positions to a system.
using AddConditions = std::function<void(const State& state, const System& system)>;

/// Fills the predicted positions by one step of backward Euler, p(t + h) = p(t) + h (v + dv), where pins move
/// as the surroundings have it. External forces are those of the step's beginning; the drag of the air alone
/// is implicit too. `matrix` must have a block for every pair that a condition joins. For `tolerance` see
/// solve().
void predict(const Frame& frame, double time_step_s, double tolerance, const AddConditions& add_conditions,
             BlockMatrix& matrix, State& state);

}  // namespace taut::sim::implicit
