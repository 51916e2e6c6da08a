#pragma once

#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// Sets what springs and triangles that are too short give back of their error in one time step. With a
/// stiffness k in N/m and the mobility w it is k dt^2 w / (1 + k dt^2 w), as of a compliant constraint
/// (Macklin, Mueller and Chentanez 2016).
void set_short_shares(double stiffness_n_per_m, double time_step_s, Layout& layout, SurfaceLanes& surface);

/// Returns what springs' ends, or triangles, weigh against a correction, on average; 1/kg.
double mean_mobility_per_kg(const Layout& layout);

/// Returns the largest stiffness that time steps of this length follow, in N/m: stiffer springs give back
/// almost all of their error and push no harder. Infinite where nothing can move.
double followed_compression(double mobility_per_kg, double time_step_s);

}  // namespace taut::sim::bounded
