#pragma once

#include "sim/pins.hpp"
#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// Returns the longest time step, in seconds, in which Hooke's springs stay stable under Verlet's explicit
/// prediction. Velocities lag by one step. The condition is
///   dt^2 w^2 + 2 c dt < 4,   w^2 <= 2 sum k / m,   c <= 2 sum d / m + air drag
/// with the stiffness k and the damping d of the springs at a vertex (Gershgorin's bound on the eigenvalues).
/// A margin is left for wind and hands; their own formulas limit how much they add. Returns infinity if
/// nothing can swing.
double stable_time_step_s(const Garment& garment, const Pins& pins, const SpringStiffness& stiffness,
                          double air_drag_per_s);

}  // namespace taut::sim
