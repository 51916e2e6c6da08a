#pragma once

#include "sim/pins.hpp"
#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// The longest time step in which Verlet's explicit prediction, with velocities that lag by a step, keeps
/// Hooke's springs from swinging up:
///   dt^2 w^2 + 2 c dt < 4,   w^2 <= 2 sum k / m,   c <= 2 sum d / m + air drag
/// with the stiffness k and damping d of the springs about a vertex (Gershgorin's bound on the eigenvalues).
/// Less a margin for wind and hands, whose own formulas limit how much they add. In seconds; infinite where
/// nothing swings.
double stable_time_step_s(const Garment& garment, const Pins& pins, const SpringStiffness& stiffness,
                          double air_drag_per_s);

}  // namespace taut::sim
