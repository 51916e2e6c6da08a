#pragma once

#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Eq. (1): p(t + dt) = 2 p(t) - p(t - dt) + a(t) dt^2 with a = f / m (Verlet 1967). Positions are in metres.
/// All spans have one entry per vertex. A pinned vertex (inverse mass 0) is predicted to stay at its current
/// position.
void predict_positions(std::span<const Vec3> previous, std::span<const Vec3> current,
                       std::span<const Vec3> forces_n, std::span<const double> inverse_masses_per_kg,
                       double time_step_s, std::span<Vec3> predicted);

}  // namespace taut::sim
