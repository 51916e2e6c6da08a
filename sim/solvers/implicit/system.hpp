#pragma once

#include <span>

#include "sim/solvers/implicit/block_matrix.hpp"
#include "sim/solvers/implicit/conditions.hpp"

namespace taut::sim::implicit {

/// The linear system of one step of backward Euler (Baraff and Witkin 1998, section 3, eq. 6, times the
/// mass):
///   (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v)
/// for the change dv of the velocities v in a time step h.
struct System {
  double time_step_s = 0.0;
  std::span<const Vec3> velocities_m_per_s;
  BlockMatrix& matrix;
  std::span<Vec3> right_side;  ///< in N s
};

/// How a condition is opposed: its stiffness, and its damping as a fraction of that per unit of time.
struct Stiffness {
  double k = 0.0;
  double damping_s = 0.0;
};

/// Adds inertia, whose blocks are m (1 + h c), and the forces `forces_n`; c is what the forces contain of a
/// drag, -m c v.
void add_inertia(std::span<const double> masses_kg, std::span<const Vec3> forces_n, double air_drag_per_s,
                 const System& system);

/// Adds a condition's force with damping (eqs. 7 and 11), f_i = -(k C + d dC/dt) dC/dx_i with d = damping_s
/// k, and its derivatives (eqs. 8 and 12). Terms are left out that would make the matrix indefinite: those
/// with the second derivative of C where k C + d dC/dt is negative, as in cloth that is pressed together, and
/// those that are not symmetric.
void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system);

}  // namespace taut::sim::implicit
